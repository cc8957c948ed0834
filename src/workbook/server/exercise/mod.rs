//! What a reader does with an exercise on its page: the same as in the terminal, with the same files.
//!
//! | asked | does |
//! |---|---|
//! | `GET /__workbook/exercises?names=a,b` | tells how the reader stands with these exercises |
//! | `POST …/exercise/CHAPTER/NAME/save` | writes the answer, unless the file holds what the reader has not seen |
//! | `POST …/check` | the same, and checks it |
//! | `POST …/done` | the same, and marks an explanation as done |
//! | `POST …/hint` | one more hint |
//! | `POST …/solution` | the solution, when it is asked for twice or the exercise is solved |
//! | `POST …/reset` | begins anew; the answer is kept |
//! | `POST …/fresh` | the same with fresh numbers |
//!
//! The rules are those of [`practice`]; here they only get an address.

mod desks;
mod reply;

use axum::Router;
use axum::extract::{Path, Query, State as Shared};
use axum::response::{IntoResponse, Json, Response};
use axum::routing::{get, post};
use serde::Deserialize;

pub use desks::Desks;
use desks::Table;
use reply::{Looked, Next, Refused, Reply, SolutionReply};

use super::Site;
use crate::book::exercise::Exercise;
use crate::check::tableau::sheet;
use crate::workbook::feedback::page;
use crate::workbook::practice::begin::{Fresh, any_seed, begin_fresh};
use crate::workbook::practice::check::{check as check_answer, compare, keep_picture};
use crate::workbook::practice::save::{Draft, Saved, save as save_draft};
use crate::workbook::practice::standing::{judged, with_fields};
use crate::workbook::practice::{self, PracticeError, shown};

/// What runs behind the guard.
pub(super) fn routes() -> Router<Site> {
    let of = |what: &str| format!("/__workbook/exercise/{{chapter}}/{{name}}/{what}");
    Router::new()
        .route("/__workbook/exercises", get(standings))
        .route(&of("save"), post(save))
        .route(&of("check"), post(check))
        .route(&of("done"), post(done))
        .route(&of("hint"), post(hint))
        .route(&of("solution"), post(solution))
        .route(&of("reset"), post(reset))
        .route(&of("fresh"), post(fresh))
}

/// Which exercises a page asks about.
#[derive(Deserialize)]
struct Asked {
    /// Their names, with commas between them.
    #[serde(default)]
    names: String,
}

/// An answer as the page sends it.
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
struct Written {
    /// The text of the answer.
    text: Option<String>,
    /// Or the fields of a table, with the round that dealt its numbers.
    fields: Option<sheet::Fields>,
    #[serde(default)]
    round: u64,
    /// The digest of the text on which the reader has worked.
    base: Option<String>,
    /// Whether he has seen that the file holds another text by now, and wants his own.
    #[serde(default)]
    replace: bool,
}

/// `CHAPTER/NAME`.
type Name = Path<(String, String)>;

/// Does something at the desk, on a thread that may block.
async fn at_desk<T: Send + 'static>(
    site: &Site,
    work: impl FnOnce(&Table) -> Result<T, PracticeError> + Send + 'static,
) -> Result<T, Refused> {
    let (desks, build) = (site.desks.clone(), site.build());
    tokio::task::spawn_blocking(move || Ok(work(&*desks.table(&build)?)?))
        .await
        .unwrap_or(Err(Refused::Broken))
}

/// The same for one exercise.
async fn at_exercise(
    site: Site,
    Path((chapter, name)): Name,
    work: impl FnOnce(&Table, &Exercise) -> Result<Reply, PracticeError> + Send + 'static,
) -> Result<Json<Reply>, Refused> {
    at_desk(&site, move |table| {
        let exercise = table.desk.exercise(&format!("{chapter}/{name}"))?;
        work(table, exercise)
    })
    .await
    .map(Json)
}

async fn standings(
    Shared(site): Shared<Site>,
    Query(asked): Query<Asked>,
) -> Result<Json<Vec<Looked>>, Refused> {
    let found = at_desk(&site, move |table| {
        let names = asked.names.split(',').filter(|name| !name.is_empty());
        Ok(names.map(|name| Looked::at(&table.desk, name)).collect())
    });
    found.await.map(Json)
}

async fn save(
    Shared(site): Shared<Site>,
    name: Name,
    Json(written): Json<Written>,
) -> Result<Json<Reply>, Refused> {
    at_exercise(site, name, move |table, exercise| {
        match put_down(table, exercise, &written)? {
            Ok(backup) => {
                let mut reply = Reply::new(table, exercise)?;
                reply.backup = backup;
                Ok(reply)
            }
            Err(reply) => Ok(*reply),
        }
    })
    .await
}

/// Writes an answer into its file; otherwise the reply that says why not.
fn put_down(
    table: &Table,
    exercise: &Exercise,
    written: &Written,
) -> Result<Result<Option<String>, Box<Reply>>, PracticeError> {
    let desk = &table.desk;
    let filled = match (&written.fields, &written.text) {
        (Some(fields), _) => match with_fields(desk, exercise, written.round, fields)? {
            Ok(text) => text,
            // The table says which field it is about.
            Err(_) => {
                let mut reply = Reply::new(table, exercise)?;
                reply.tableau = judged(exercise, written.round, fields);
                return Ok(Err(Box::new(reply)));
            }
        },
        (None, Some(text)) => text.clone(),
        (None, None) => return Ok(Ok(None)),
    };
    let draft = Draft {
        text: &filled,
        base: written.base.as_deref(),
        replace: written.replace,
    };
    Ok(match save_draft(desk, exercise, draft)? {
        Saved::Written { backup, .. } => Ok(backup.map(|file| shown(&file).display().to_string())),
        Saved::Conflict { .. } => {
            let mut reply = Reply::new(table, exercise)?;
            reply.conflict = true;
            Err(Box::new(reply))
        }
    })
}

/// Checks through the queue, since it compiles and runs a program.
async fn check(
    Shared(site): Shared<Site>,
    Path((chapter, name)): Name,
    Json(written): Json<Written>,
) -> Response {
    let (desks, build) = (site.desks.clone(), site.build());
    let work = move |stop| -> Result<Reply, Refused> {
        let table = desks.table(&build)?;
        let desk = &table.desk;
        let exercise = desk.exercise(&format!("{chapter}/{name}"))?;
        let backup = match put_down(&table, exercise, &written)? {
            Ok(backup) => backup,
            Err(reply) => return Ok(*reply),
        };
        let Some(tested) = &exercise.tested else {
            compare(desk, exercise, false)?;
            return Ok(Reply::new(&table, exercise)?);
        };
        let checker = desks.checker()?.until(stop);
        let verdict = check_answer(desk, exercise, tested, &checker)?;
        keep_picture(desk, exercise, &verdict);
        let mut reply = Reply::new(&table, exercise)?;
        reply.backup = backup;
        reply.html = Some(page::described(&verdict, &exercise.front.title));
        reply.tableau = match &written.fields {
            Some(fields) => judged(exercise, written.round, fields),
            None => None,
        };
        if verdict.passed() {
            reply.next = Next::of(&table)?;
        }
        reply.verdict = Some(verdict);
        Ok(reply)
    };
    match site.queue.run(work).await {
        Ok(Ok(reply)) => Json(reply).into_response(),
        Ok(Err(refused)) => refused.into_response(),
        Err(full) => full.into_response(),
    }
}

async fn done(
    Shared(site): Shared<Site>,
    name: Name,
    Json(written): Json<Written>,
) -> Result<Json<Reply>, Refused> {
    at_exercise(site, name, move |table, exercise| {
        if exercise.tested.is_some() {
            let name = &exercise.name;
            let text = format!("`{name}` is judged by its tests\nnext step: check it");
            return Err(PracticeError::Unfit(text));
        }
        if let Err(reply) = put_down(table, exercise, &written)? {
            return Ok(*reply);
        }
        compare(&table.desk, exercise, true)?;
        let mut reply = Reply::new(table, exercise)?;
        reply.next = Next::of(table)?;
        Ok(reply)
    })
    .await
}

async fn hint(Shared(site): Shared<Site>, name: Name) -> Result<Json<Reply>, Refused> {
    at_exercise(site, name, |table, exercise| {
        practice::hint::take(&table.desk, exercise)?;
        Reply::new(table, exercise)
    })
    .await
}

async fn solution(Shared(site): Shared<Site>, name: Name) -> Result<Json<Reply>, Refused> {
    at_exercise(site, name, |table, exercise| {
        let asked = practice::solution::ask(&table.desk, exercise)?;
        let mut reply = Reply::new(table, exercise)?;
        reply.solution = Some(SolutionReply {
            hints_left: asked.hints_left,
            source: asked.may_see.then_some(asked.source),
        });
        Ok(reply)
    })
    .await
}

async fn reset(Shared(site): Shared<Site>, name: Name) -> Result<Json<Reply>, Refused> {
    at_exercise(site, name, |table, exercise| {
        let backup = practice::reset::reset(&table.desk, exercise)?;
        let mut reply = Reply::new(table, exercise)?;
        reply.backup = Some(shown(&backup).display().to_string());
        Ok(reply)
    })
    .await
}

async fn fresh(Shared(site): Shared<Site>, name: Name) -> Result<Json<Reply>, Refused> {
    at_exercise(site, name, |table, exercise| {
        let numbers = Fresh::deal(exercise, any_seed())?;
        let (_, backup) = begin_fresh(&table.desk, exercise, &numbers)?;
        let mut reply = Reply::new(table, exercise)?;
        reply.backup = backup.map(|file| shown(&file).display().to_string());
        Ok(reply)
    })
    .await
}
