//! Width of a text, and its division into lines.

/// Font size of a text in pixels; at least 2.5 % of the width of a figure, so that it is 10 pixels on a screen 400 pixels wide.
pub(super) const FONT: i32 = 14;
/// Font size of a title in pixels.
pub(super) const TITLE: i32 = 16;

/// Estimates the width of a text in pixels at the font size [`FONT`]. Fonts are not measured: the widths are those of a wide font.
pub(super) fn width(text: &str) -> i32 {
    let letter = |c: char| match c {
        'i' | 'l' | 'j' | '.' | ',' | ':' | ';' | '\'' | '|' | '!' | ' ' | '\u{a0}' => 0.33,
        'f' | 't' | 'r' | '(' | ')' | '[' | ']' | '/' | '⁻' | '⁰'..='⁹' | '₀'..='₉' | '¹' | '²' | '³' => {
            0.4
        }
        'm' | 'w' | 'M' | 'W' | '%' | '=' | '−' | '+' | '<' | '>' | '·' => 0.85,
        'A'..='Z' => 0.69,
        _ => 0.61,
    };
    (f64::from(FONT) * text.chars().map(letter).sum::<f64>()).ceil() as i32
}

/// Divides a text into lines of at most `most` pixels. A longer word has a line of its own.
pub(super) fn wrapped(text: &str, most: i32) -> Vec<String> {
    let mut lines: Vec<String> = vec![];
    // An equation is a word.
    let text = text.replace(" = ", "\u{a0}=\u{a0}");
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if width(&format!("{line} {word}")) <= most => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.into()),
        }
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_short_and_lose_nothing() {
        let lines = wrapped("one two three four", 70);
        assert!(lines.len() > 1 && lines.iter().all(|line| width(line) <= 70));
        assert_eq!(lines.join(" "), "one two three four");
    }
}
