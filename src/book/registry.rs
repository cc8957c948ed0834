//! The registry: which figures the chapters draw and which texts they compute.
//!
//! A chapter adds its computed texts here once, and its figures to the [gallery]; adding a figure or a computed
//! text afterwards touches the chapter's files alone.

use std::collections::BTreeMap;

use super::error::{Problem, most_similar};
use crate::figure::{Figure, FigureError};
use crate::gallery;

/// A figure as the book needs it.
pub struct RegisteredFigure {
    /// The id.
    pub id: String,
    /// The title, for the caption.
    pub title: String,
    /// What it shows, for those who cannot see it.
    pub description: String,
    /// The part of the gallery that draws it again with a reader's values, if it has any.
    pub live: Option<&'static str>,
    /// Draws it with its default parameters.
    pub draw: Box<dyn Fn() -> Result<Drawing, String> + Send + Sync>,
}

/// A figure that was drawn.
#[derive(Debug, Clone, Default)]
pub struct Drawing {
    /// The picture.
    pub svg: String,
    /// The statements whose laws it shows to a reader who changes something, each once.
    pub laws: Vec<String>,
}

impl Drawing {
    fn of(figure: &Figure) -> Result<Self, FigureError> {
        let plot = figure.plot(&figure.defaults())?;
        let mut laws: Vec<String> = Vec::new();
        for reading in plot.readings() {
            if !laws.contains(&reading.statement) {
                laws.push(reading.statement.clone());
            }
        }
        Ok(Self {
            svg: plot.svg(),
            laws,
        })
    }
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
        gallery::PARTS
            .iter()
            .fold(Self::default(), |registry, (part, figures)| {
                registry.with_figures(part, figures())
            })
            .with_all_computed("affine", affine::computed::all())
            .with_all_computed("bezier", bezier::computed::all())
            .with_all_computed("subdivision", subdivision::computed::all())
    }

    /// Adds the figures of a part of the gallery.
    #[must_use]
    fn with_figures(self, part: &'static str, figures: Vec<Figure>) -> Self {
        figures.into_iter().fold(self, |registry, figure| {
            registry.with_figure(RegisteredFigure {
                id: figure.id().to_owned(),
                title: figure.title().to_owned(),
                description: figure.description().to_owned(),
                live: (!figure.parameters().is_empty()).then_some(part),
                draw: Box::new(move || Drawing::of(&figure).map_err(|e| e.to_string())),
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
