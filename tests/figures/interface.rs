//! What the interface of figures promises, beyond what its examples show.

use cagd::figure::{
    Axes, BoxError, Canvas, Figure, FigureError, PlotError, PointStyle, Side, Style, Value, Values,
};

fn figure(
    draw: impl Fn(&Values, &mut Canvas) -> Result<(), BoxError> + Send + Sync + 'static,
) -> Figure {
    Figure::new(
        "demo",
        "A demonstration",
        "A figure that is drawn only in this test.",
    )
    .handles("b", [[0.0, 0.0], [2.0, 1.0]])
    .handle("p", [1.0, 0.5])
    .slider("t", 0.0..=1.0, 0.5)
    .stepper("n", 1..=4, 2)
    .draw(draw)
}

fn segment() -> Figure {
    figure(|values, canvas| {
        let ends = values.points("b")?;
        canvas.segment("chord", ends[0], ends[1], Style::Tangent);
        canvas.point("p", values.point("p")?, PointStyle::Result);
        Ok(())
    })
}

#[track_caller]
fn refused(values: impl FnOnce(Values) -> Values) -> FigureError {
    let figure = segment();
    figure
        .plot(&values(figure.defaults()))
        .expect_err("values that do not suit")
}

#[track_caller]
fn undrawable(draw: impl Fn(&mut Canvas) + Send + Sync + 'static) -> FigureError {
    let figure = figure(move |_, canvas| {
        draw(canvas);
        Ok(())
    });
    figure
        .plot(&figure.defaults())
        .expect_err("a mistake in the drawing")
}

#[test]
fn values_that_do_not_suit_are_refused() {
    assert_eq!(
        refused(|v| v.with_number("t", 1.5)).to_string(),
        "parameter t of figure demo must lie in [0, 1], not at 1.5"
    );
    assert!(matches!(
        refused(|v| v.with_number("t", f64::NAN)),
        FigureError::NotFinite { .. }
    ));
    assert!(matches!(
        refused(|v| v.with_count("n", 5)),
        FigureError::OutOfRange { .. }
    ));
    assert!(matches!(
        refused(|v| v.with_point("p", [f64::INFINITY, 0.0])),
        FigureError::NotFinite { .. }
    ));
    assert!(matches!(
        refused(|v| v.with_point("p", [1e9, 0.0])),
        FigureError::OutOfRange { .. }
    ));
    assert!(matches!(
        refused(|v| v.with_points("b", [[0.0, 0.0]])),
        FigureError::WrongCount { .. }
    ));
    assert!(matches!(
        refused(|v| v.with("t", Value::Count(1))),
        FigureError::WrongKind { .. }
    ));
    assert!(matches!(
        refused(|v| v.with_number("s", 0.5)),
        FigureError::UnknownParameter { .. }
    ));
}

#[test]
fn questions_about_values_are_checked() {
    let values = segment().defaults();
    assert!(matches!(
        values.number("s"),
        Err(FigureError::UnknownParameter { .. })
    ));
    assert!(matches!(
        values.number("n"),
        Err(FigureError::WrongKind { .. })
    ));
    assert!(matches!(
        values.points("p"),
        Err(FigureError::WrongKind { .. })
    ));
}

#[test]
fn text_that_is_no_value_is_refused() {
    let figure = segment();
    for text in ["t", "t=half", "p=1", "b=0,0;1", "n=2.5"] {
        assert!(
            matches!(figure.values(text), Err(FigureError::Unreadable { .. })),
            "{text}"
        );
    }
    assert!(matches!(
        figure.values("s=1"),
        Err(FigureError::UnknownParameter { .. })
    ));
    assert!(matches!(
        figure.values("t=7"),
        Err(FigureError::OutOfRange { .. })
    ));
    assert!(matches!(
        figure.values("t=NaN"),
        Err(FigureError::NotFinite { .. })
    ));
}

#[test]
fn mistakes_in_a_drawing_are_reported() {
    let twice = undrawable(|canvas| {
        canvas.point("p", [0.0, 0.0], PointStyle::Result);
        canvas.point("p", [1.0, 0.0], PointStyle::Result);
    });
    assert!(matches!(twice, FigureError::NameTaken { .. }));
    let nowhere = undrawable(|canvas| canvas.graph("f", 0.0..=1.0, |x| 1.0 / x, Style::Curve));
    assert!(matches!(nowhere, FigureError::NoPlace { .. }));
    let below_zero = undrawable(|canvas| {
        canvas.axes(Axes::new("k", "d").logarithmic());
        canvas.point("p", [1.0, 0.0], PointStyle::Result);
    });
    assert!(matches!(below_zero, FigureError::NoPlace { .. }));
    let none: [[f64; 2]; 0] = [];
    let empty = undrawable(move |canvas| canvas.polyline("l", none, Style::Curve));
    assert!(matches!(empty, FigureError::TooFewPoints { .. }));
    let unreadable = undrawable(|canvas| canvas.label("b_{0", [0.0, 0.0]));
    assert!(matches!(unreadable, FigureError::Label { .. }));
    let blank = Figure::new("demo", "A demonstration", "Without a drawing function.");
    assert!(matches!(blank.svg(), Err(FigureError::NothingDrawn { .. })));
    let double = segment().slider("t", 0.0..=1.0, 0.5);
    assert!(matches!(
        double.svg(),
        Err(FigureError::DuplicateParameter { .. })
    ));
    let elsewhere = segment().handle_in("hodograph", "q", [0.0, 0.0]);
    assert!(matches!(
        elsewhere.svg(),
        Err(FigureError::UnknownPanel { .. })
    ));
    let failing = figure(|_, _| Err("no such curve".into()));
    assert!(matches!(failing.svg(), Err(FigureError::Drawing { .. })));
}

#[test]
fn a_name_in_two_panels_must_be_qualified() -> Result<(), BoxError> {
    let figure = figure(|_, canvas| {
        for (panel, x) in [("left", 1.0), ("right", 2.0)] {
            canvas.panel(panel);
            canvas.point("p", [x, 0.0], PointStyle::Result);
        }
        Ok(())
    });
    let plot = figure.plot(&figure.defaults())?;
    assert!(matches!(plot.point("p"), Err(PlotError::Ambiguous { .. })));
    assert_eq!(plot.point("right/p")?[0], 2.0);
    let swapped = plot.swapped("left/p", "right/p")?;
    assert_eq!(swapped.point("right/p")?[0], 1.0);
    assert!(
        plot.without("left/p")?.point("p").is_ok(),
        "now only one panel has it"
    );
    assert!(matches!(
        plot.replaced("left/p", [[0.0; 2]; 2]),
        Err(PlotError::WrongShape { .. })
    ));
    Ok(())
}

#[test]
fn the_window_stays_while_a_handle_moves() -> Result<(), BoxError> {
    let figure = segment();
    let still = figure.plot(&figure.defaults())?.picture();
    let moved = figure
        .plot(&figure.defaults().with_point("p", [1.5, 0.9]))?
        .picture();
    assert_eq!(still.frames, moved.frames);
    assert_ne!(still.svg, moved.svg);
    Ok(())
}

#[test]
fn handles_are_where_their_points_are_drawn() -> Result<(), BoxError> {
    let figure = segment();
    let plot = figure.plot(&figure.defaults())?;
    let picture = plot.picture();
    let frame = &picture.frames[0];
    let p = plot
        .handles()
        .iter()
        .find(|handle| handle.parameter == "p")
        .ok_or("no handle p")?;
    let [x, y] = frame.to_picture([p.place[0], p.place[1]]);
    let document = roxmltree::Document::parse(&picture.svg).map_err(|e| e.to_string())?;
    let drawn = document
        .descendants()
        .find(|node| node.attribute("class") == Some("result"))
        .ok_or("no point")?;
    for (name, expected) in [("cx", x), ("cy", y)] {
        let found: f64 = drawn.attribute(name).ok_or("no coordinate")?.parse()?;
        // Positions are written in hundredths, cut off by plotters.
        assert!(
            (found - expected).abs() <= 0.011,
            "{name}: {found}, expected {expected}"
        );
    }
    assert_eq!(picture.handles.len(), plot.handles().len());
    assert_eq!(picture.handles[2], [x, y], "after the two points of b");
    let back = frame.to_world([x, y]);
    // Two products and two quotients each way on numbers of at most 1000.
    assert!((back[0] - p.place[0]).abs() < 1e-12 && (back[1] - p.place[1]).abs() < 1e-12);
    Ok(())
}

#[test]
fn what_leaves_the_panel_is_cut_off() -> Result<(), BoxError> {
    let figure = figure(|_, canvas| {
        canvas.window([0.0, 0.0], [2.0, 1.0]);
        canvas.circle("large", [0.0, 0.0], 1e6, Style::Tangent);
        canvas.line("line", [0.0, 0.2], [1.0, 0.4], Style::Guide);
        canvas.arrow("arrow", [1.0, 0.5], [1e5, 0.5], Style::Tangent);
        canvas.polygon(
            "region",
            [[-1e5, -1e5], [1e5, -1e5], [0.0, 1e5]],
            Style::Region,
        );
        canvas.point("far", [1e5, 0.0], PointStyle::Result);
        canvas.label("far", [1e5, 0.0]);
        canvas.text("note", "a note", [1.0, 1.0], Side::Below);
        Ok(())
    });
    let picture = figure.plot(&figure.defaults())?.picture();
    let document = roxmltree::Document::parse(&picture.svg).map_err(|e| e.to_string())?;
    let circles = document
        .descendants()
        .filter(|node| node.has_tag_name("circle"))
        .count();
    assert_eq!(
        circles, 0,
        "neither the point far away nor the whole large circle is drawn"
    );
    assert_eq!(
        picture
            .labels
            .iter()
            .map(|(text, _)| text.as_str())
            .collect::<Vec<_>>(),
        ["a note"]
    );
    let [width, height] = picture.size;
    for path in document
        .descendants()
        .filter_map(|node| node.attribute("d"))
    {
        for [x, y] in vertices(path)? {
            // Differences are exact quotients of integers; adding them up rounds far below a hundredth.
            let inside =
                (-0.01..=width + 0.01).contains(&x) && (-0.01..=height + 0.01).contains(&y);
            assert!(inside, "({x}, {y}) of {path}");
        }
    }
    Ok(())
}

/// The vertices of a path of moves, relative lines and closings.
fn vertices(path: &str) -> Result<Vec<[f64; 2]>, BoxError> {
    let spaced = path
        .replace('-', " -")
        .replace(['z', 'l'], " l ")
        .replace('M', " M ");
    let (mut at, mut relative, mut found) = ([0.0, 0.0], false, vec![]);
    let mut words = spaced.split_whitespace();
    while let Some(word) = words.next() {
        match word {
            "M" => relative = false,
            "l" => relative = true,
            x => {
                let step: [f64; 2] = [
                    x.parse()?,
                    words
                        .next()
                        .ok_or("an odd number of coordinates")?
                        .parse()?,
                ];
                at = if relative {
                    [at[0] + step[0], at[1] + step[1]]
                } else {
                    step
                };
                found.push(at);
            }
        }
    }
    Ok(found)
}

#[test]
fn paths_are_read_as_they_are_written() -> Result<(), BoxError> {
    assert_eq!(
        vertices("M1 2l3-1 0 .5zM5 5")?,
        [[1.0, 2.0], [4.0, 1.0], [4.0, 1.5], [5.0, 5.0]]
    );
    assert!(vertices("M1").is_err());
    Ok(())
}
