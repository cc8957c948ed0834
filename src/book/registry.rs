//! The registry: which figures the chapters draw and which texts they compute.
//!
//! A chapter adds itself here once; adding a figure or a computed text afterwards touches the chapter's files alone.

use std::collections::BTreeMap;

use super::error::{Problem, most_similar};
use crate::figure::Figure;

/// A figure as the book needs it.
pub struct RegisteredFigure {
    /// The id.
    pub id: String,
    /// The title, for the caption.
    pub title: String,
    /// What it shows, for those who cannot see it.
    pub description: String,
    /// Whether a reader can change something in it.
    pub live: bool,
    /// Draws it with its default parameters, as SVG.
    pub draw: Box<dyn Fn() -> Result<String, String> + Send + Sync>,
}

/// A function that computes Markdown.
pub type Compute = fn() -> String;

/// All figures and computed texts.
#[derive(Default)]
pub struct Registry {
    figures: BTreeMap<String, RegisteredFigure>,
    computed: BTreeMap<(String, String), Compute>,
}

impl Registry {
    /// The figures and computed texts of all chapters.
    pub fn of_all_chapters() -> Self {
        use crate::{affine, bezier, subdivision};
        Self::default()
            .with_figures(affine::figures::all())
            .with_all_computed("affine", affine::computed::all())
            .with_figures(bezier::figures::all())
            .with_all_computed("bezier", bezier::computed::all())
            .with_figures(subdivision::figures::all())
            .with_all_computed("subdivision", subdivision::computed::all())
    }

    /// Adds the figures of a chapter.
    #[must_use]
    fn with_figures(self, figures: Vec<Figure>) -> Self {
        figures.into_iter().fold(self, |registry, figure| {
            registry.with_figure(RegisteredFigure {
                id: figure.id().to_owned(),
                title: figure.title().to_owned(),
                description: figure.description().to_owned(),
                live: !figure.parameters().is_empty(),
                draw: Box::new(move || figure.svg().map_err(|e| e.to_string())),
            })
        })
    }

    /// Adds the computed texts of a chapter.
    #[must_use]
    fn with_all_computed(
        self,
        chapter: &str,
        computed: impl IntoIterator<Item = (&'static str, Compute)>,
    ) -> Self {
        computed
            .into_iter()
            .fold(self, |registry, (name, compute)| {
                registry.with_computed(chapter, name, compute)
            })
    }

    /// Adds a figure.
    #[must_use]
    pub fn with_figure(mut self, figure: RegisteredFigure) -> Self {
        self.figures.insert(figure.id.clone(), figure);
        self
    }

    /// Adds a computed text.
    #[must_use]
    pub fn with_computed(mut self, chapter: &str, name: &str, compute: Compute) -> Self {
        self.computed
            .insert((chapter.to_owned(), name.to_owned()), compute);
        self
    }

    /// Whether a figure with this id is drawn.
    pub fn draws(&self, id: &str) -> bool {
        self.figures.contains_key(id)
    }

    /// The figure with this id.
    ///
    /// # Errors
    ///
    /// [`Problem::UnknownFigure`] if there is none, [`Problem::MuteFigure`] if it has no title or no description.
    pub fn figure(&self, id: &str) -> Result<&RegisteredFigure, Problem> {
        let figure = self.figures.get(id).ok_or_else(|| Problem::UnknownFigure {
            id: id.to_owned(),
            near: most_similar(id, self.figures.keys().map(String::as_str)),
        })?;
        let missing = match (figure.title.trim(), figure.description.trim()) {
            ("", _) => "title",
            (_, "") => "description",
            _ => return Ok(figure),
        };
        Err(Problem::MuteFigure {
            id: id.to_owned(),
            missing,
        })
    }

    /// The text that the function `name` of `chapter` computes.
    ///
    /// # Errors
    ///
    /// [`Problem::UnknownComputed`] if there is no such function.
    pub fn computed(&self, chapter: &str, name: &str) -> Result<String, Problem> {
        let key = (chapter.to_owned(), name.to_owned());
        match self.computed.get(&key) {
            Some(compute) => Ok(compute()),
            None => Err(Problem::UnknownComputed {
                near: most_similar(
                    name,
                    self.computed
                        .keys()
                        .filter(|(of, _)| of == chapter)
                        .map(|(_, name)| name.as_str()),
                ),
                chapter: key.0,
                name: key.1,
            }),
        }
    }
}
