//! How wide texts are, and where names go so that none covers another.

/// The width of a text in pixels. No fonts are measured here: these are the widths of a wide font, so that others have room.
pub(super) fn width(text: &str, bold: bool) -> i32 {
    let letter = |c: char| match c {
        'i' | 'l' | 'j' | '.' | ',' | ':' | ';' | '\'' | '|' | '!' | ' ' | '\u{a0}' => 0.33,
        'f' | 't' | 'r' | '(' | ')' | '[' | ']' | '/' | '⁻' | '⁰'..='⁹' | '₀'..='₉' | '¹' | '²' | '³' => {
            0.4
        }
        'm' | 'w' | 'M' | 'W' | '%' | '=' | '−' | '+' | '<' | '>' | '·' => 0.85,
        'A'..='Z' => 0.69,
        _ => 0.61,
    };
    let size = if bold { 14.0 * 1.09 } else { 12.0 };
    (size * text.chars().map(letter).sum::<f64>()).ceil() as i32
}

/// Words in lines that are not wider than a number of pixels, if no word is.
pub(super) fn wrapped(text: &str, most: i32) -> Vec<String> {
    let mut lines: Vec<String> = vec![];
    // An equation is a word.
    let text = text.replace(" = ", "\u{a0}=\u{a0}");
    for word in text.split(' ') {
        match lines.last_mut() {
            Some(line) if width(&format!("{line} {word}"), false) <= most => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.into()),
        }
    }
    lines
}

/// Heights moved apart to at least a distance, as little as it takes from above and then from below, within `least..=most`.
pub(super) fn apart(heights: &mut [i32], distance: i32, least: i32, most: i32) {
    let mut order: Vec<usize> = (0..heights.len()).collect();
    order.sort_by_key(|i| heights[*i]);
    let mut lowest = least;
    for i in &order {
        heights[*i] = heights[*i].max(lowest);
        lowest = heights[*i] + distance;
    }
    let mut highest = most;
    for i in order.iter().rev() {
        heights[*i] = heights[*i].min(highest);
        highest = heights[*i] - distance;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_do_not_meet() {
        let mut heights = [50, 48, 52, 100];
        apart(&mut heights, 10, 0, 100);
        assert_eq!(heights, [58, 48, 68, 100]);
        let mut heights = [95, 96, 97];
        apart(&mut heights, 10, 0, 100);
        assert_eq!(heights, [80, 90, 100]);
    }

    #[test]
    fn lines_are_short_and_lose_nothing() {
        let lines = wrapped("one two three four", 60);
        assert!(lines.iter().all(|line| width(line, false) <= 60));
        assert_eq!(lines.join(" "), "one two three four");
    }
}
