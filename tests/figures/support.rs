//! How a figure is tested.

use cagd::figure::{BoxError, Figure, Place, Plot, PlotError};

/// What a check says of a plot.
pub(crate) type Checked = Result<(), BoxError>;

/// A figure whose check accepts its default picture, but has not refused anything yet.
#[must_use = "name at least one wrong picture with `rejects`, then take the `snapshot`"]
pub(crate) struct Accepted {
    plot: Plot,
    check: fn(&Plot) -> Checked,
}

/// A figure whose check has refused a wrong picture.
#[must_use = "end with `snapshot`"]
pub(crate) struct Proved(Accepted);

/// Draws a figure with its default values and checks what was plotted.
#[track_caller]
pub(crate) fn figure_test(figure: Figure, check: fn(&Plot) -> Checked) -> Accepted {
    let plot = match figure.plot(&figure.defaults()) {
        Ok(plot) => plot,
        Err(error) => panic!("{} cannot be drawn: {error}", figure.id()),
    };
    if let Err(error) = check(&plot) {
        panic!("what {} plots is not right: {error}", figure.id());
    }
    Accepted { plot, check }
}

impl Accepted {
    /// Asserts that the check refuses the plot after `spoil` has made it wrong; `what` says what is wrong then.
    #[track_caller]
    pub(crate) fn rejects(
        self,
        what: &str,
        spoil: impl FnOnce(&Plot) -> Result<Plot, PlotError>,
    ) -> Proved {
        let wrong = match spoil(&self.plot) {
            Ok(wrong) => wrong,
            Err(error) => panic!("{what}: the plot could not be spoilt: {error}"),
        };
        assert_ne!(wrong, self.plot, "{what}: nothing was spoilt");
        assert!(
            (self.check)(&wrong).is_err(),
            "the check of {} accepts {what}",
            self.plot.id()
        );
        Proved(self)
    }
}

impl Proved {
    /// As [`Accepted::rejects`], for another wrong plot.
    #[track_caller]
    pub(crate) fn rejects(
        self,
        what: &str,
        spoil: impl FnOnce(&Plot) -> Result<Plot, PlotError>,
    ) -> Proved {
        self.0.rejects(what, spoil)
    }

    /// Compares the picture with the reviewed one.
    #[track_caller]
    pub(crate) fn snapshot(self) {
        let plot = self.0.plot;
        let mut settings = insta::Settings::clone_current();
        settings.set_snapshot_path(snapshots(plot.id()));
        settings.set_prepend_module_to_snapshot(false);
        settings.set_omit_expression(true);
        let name = format!("{}.svg", plot.id());
        settings.bind(|| insta::assert_binary_snapshot!(name.as_str(), plot.svg().into_bytes()));
    }
}

/// The folder of the snapshots of a figure's chapter.
pub(crate) fn snapshots(id: &str) -> std::path::PathBuf {
    let chapter = id.split('-').next().unwrap_or(id);
    std::path::Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("snapshots")
        .join(chapter)
}

/// Fails with a message unless the condition holds.
pub(crate) fn ensure(condition: bool, message: impl FnOnce() -> String) -> Checked {
    if condition {
        Ok(())
    } else {
        Err(message().into())
    }
}

/// Fails unless two places agree up to `bound` in each coordinate.
pub(crate) fn near(what: &str, found: Place, expected: Place, bound: f64) -> Checked {
    let gap = (found - expected).amax();
    ensure(gap <= bound, || {
        format!("{what}: found {found}, expected {expected}, apart by {gap:e} > {bound:e}")
    })
}
