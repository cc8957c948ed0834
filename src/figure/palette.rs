//! The colours of the book's figures.
//!
//! Their hues are those of Okabe and Ito. Lightness was then chosen, for paper and for dark ground, so that lines
//! stand out from the ground and readers with any of the common kinds of colour blindness can tell them apart;
//! the tests below measure both.

/// Style sheet of a page: sets the colours of the figures for each of mdBook's themes.
///
/// Include it once a page; the figures carry all their other rules.
pub const PAGE_CSS: &str = include_str!("../../book/theme/figure.css");

/// A colour: its CSS variable, on paper, on dark ground.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Colour {
    pub(super) name: &'static str,
    pub(super) light: &'static str,
    pub(super) dark: &'static str,
}

const fn colour(name: &'static str, light: &'static str, dark: &'static str) -> Colour {
    Colour { name, light, dark }
}

pub(super) const PAPER: Colour = colour("paper", "#ffffff", "#14171c");
pub(super) const TEXT: Colour = colour("text", "#1c2026", "#e4e7eb");
pub(super) const CURVE: Colour = colour("curve", "#005fb0", "#45a2f2");
pub(super) const POLYGON: Colour = colour("polygon", "#767c88", "#838b96");
pub(super) const ACCENT: Colour = colour("accent", "#b8380a", "#f96d30");
pub(super) const LEVEL_1: Colour = colour("level-1", "#c48208", "#ffc02e");
pub(super) const LEVEL_2: Colour = colour("level-2", "#00935c", "#37d8a5");
pub(super) const LEVEL_3: Colour = colour("level-3", "#7a2a70", "#eab0e2");
pub(super) const LEVEL_4: Colour = colour("level-4", "#44291a", "#b87855");
pub(super) const GUIDE: Colour = colour("guide", "#858e99", "#78828f");
pub(super) const REGION: Colour = colour("region", "#56b4e9", "#56b4e9");

/// A face of a surface in full light and in the shadow: its outside, its inside, and where it is marked.
pub(super) const FRONT: [Colour; 2] = [
    colour("front-light", "#eef6fc", "#5788b0"),
    colour("front-shadow", "#86b4d6", "#1d3850"),
];
pub(super) const BACK: [Colour; 2] = [
    colour("back-light", "#f2efe9", "#8b857b"),
    colour("back-shadow", "#b3aca0", "#35322d"),
];
pub(super) const MARKED: [Colour; 2] = [
    colour("marked-light", "#ffe9b8", "#d9a441"),
    colour("marked-shadow", "#d9a441", "#5a4314"),
];

/// The colour that has `part` of the first and the rest of the second, both as `#rrggbb`.
pub(super) fn mixed(first: &str, second: &str, part: f64) -> String {
    let channel = |hex: &str, at: usize| {
        let digits = hex.get(at..at + 2).unwrap_or_default();
        f64::from(u8::from_str_radix(digits, 16).unwrap_or_default())
    };
    let mix = |at: usize| part * channel(first, at) + (1.0 - part) * channel(second, at);
    let [r, g, b] = [1, 3, 5].map(|at| mix(at).round() as u8);
    format!("#{r:02x}{g:02x}{b:02x}")
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The colours that a reader must tell apart; guides and regions are told by their dashes and their area.
    const LINES: [Colour; 7] = [CURVE, POLYGON, ACCENT, LEVEL_1, LEVEL_2, LEVEL_3, LEVEL_4];

    /// What an eye without one kind of cones sees, as a matrix on linear RGB (Machado, Oliveira and Fernandes 2009,
    /// severity 1): protanopia, deuteranopia, tritanopia.
    const BLINDNESS: [[[f64; 3]; 3]; 3] = [
        [
            [0.152286, 1.052583, -0.204868],
            [0.114503, 0.786281, 0.099216],
            [-0.003882, -0.048116, 1.051998],
        ],
        [
            [0.367322, 0.860646, -0.227968],
            [0.280085, 0.672501, 0.047413],
            [-0.011820, 0.042940, 0.968881],
        ],
        [
            [1.255528, -0.076749, -0.178779],
            [-0.078411, 0.930809, 0.147602],
            [0.004733, 0.691367, 0.303900],
        ],
    ];

    fn linear(hex: &str) -> [f64; 3] {
        [1, 3, 5].map(|i| {
            let c = f64::from(u8::from_str_radix(&hex[i..i + 2], 16).expect("a colour")) / 255.0;
            if c <= 0.04045 {
                c / 12.92
            } else {
                libm::pow((c + 0.055) / 1.055, 2.4)
            }
        })
    }

    fn luminance([r, g, b]: [f64; 3]) -> f64 {
        0.2126 * r + 0.7152 * g + 0.0722 * b
    }

    fn contrast(a: &str, b: &str) -> f64 {
        let (a, b) = (luminance(linear(a)), luminance(linear(b)));
        (a.max(b) + 0.05) / (a.min(b) + 0.05)
    }

    /// CIELAB under D65.
    fn lab([r, g, b]: [f64; 3]) -> [f64; 3] {
        let f = |t: f64| {
            if t > 0.008856 {
                libm::cbrt(t)
            } else {
                7.787 * t + 16.0 / 116.0
            }
        };
        let x = f((0.4124 * r + 0.3576 * g + 0.1805 * b) / 0.95047);
        let y = f(luminance([r, g, b]));
        let z = f((0.0193 * r + 0.1192 * g + 0.9505 * b) / 1.08883);
        [116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)]
    }

    fn distance(a: &str, b: &str, eye: [[f64; 3]; 3]) -> f64 {
        let seen = |hex: &str| {
            let rgb = linear(hex);
            lab(eye.map(|row| (0..3).map(|k| row[k] * rgb[k]).sum::<f64>().clamp(0.0, 1.0)))
        };
        let (a, b) = (seen(a), seen(b));
        libm::sqrt((0..3).map(|k| (a[k] - b[k]) * (a[k] - b[k])).sum())
    }

    #[test]
    fn every_line_stands_out_from_its_ground() {
        for colour in LINES.iter().chain(&[TEXT, GUIDE]) {
            for (line, ground) in [(colour.light, PAPER.light), (colour.dark, PAPER.dark)] {
                // WCAG 2.2, criterion 1.4.11: graphical objects need 3 : 1.
                let found = contrast(line, ground);
                assert!(
                    found >= 3.0,
                    "--fig-{}: {line} on {ground} is {found:.2} : 1",
                    colour.name
                );
            }
        }
        assert!(
            contrast("#fafafa", PAPER.light) < 3.0,
            "the measure can refuse"
        );
    }

    #[test]
    fn colour_blind_readers_tell_all_lines_apart() {
        // Differences of 10 are told at a glance (side by side, 2.3 is just noticed: Mahy and others 1994); thin
        // lines need more. Palettes of seven colours do not get far above 20.
        const LEAST: f64 = 14.0;
        for eye in BLINDNESS {
            for (i, a) in LINES.iter().enumerate() {
                for b in &LINES[..i] {
                    for (one, other) in [(a.light, b.light), (a.dark, b.dark)] {
                        let found = distance(one, other, eye);
                        assert!(
                            found >= LEAST,
                            "{} and {}: {one}, {other} differ by {found:.1}",
                            a.name,
                            b.name
                        );
                    }
                }
            }
        }
        // Red and green of equal lightness: the mistake that this test is for.
        assert!(distance("#d04e00", "#7f7f00", BLINDNESS[1]) < LEAST);
    }

    #[test]
    fn the_page_defines_every_colour_in_both_themes() {
        let surfaces = [FRONT, BACK, MARKED].concat();
        for Colour { name, light, dark } in LINES.iter().chain(&[GUIDE, REGION]).chain(&surfaces) {
            assert!(
                PAGE_CSS.contains(&format!("--fig-{name}: {light};")),
                "--fig-{name} on paper"
            );
            assert!(
                PAGE_CSS.contains(&format!("--fig-{name}: {dark};")),
                "--fig-{name} on dark ground"
            );
        }
    }
}
