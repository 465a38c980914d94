package org.robonewbie.simulator.server;

import java.util.ArrayList;
import java.util.List;

/**
 * Reads messages as the agents of FC Portugal do: a tag reaches from a parenthesis to the next blank, numbers consist of digits,
 * a point and a leading minus sign or are {@code nan}, and nothing is checked. Whatever does not fit shifts all that follows, which
 * shows in the values.
 */
final class FcPortugalParser {

    private final String text;
    private final List<String> tags = new ArrayList<>();
    private int position;

    FcPortugalParser(String text) {
        this.text = text;
    }

    /** Finds the next tag; empty at the end of the message. */
    String nextTag() {
        int open = text.indexOf('(', position);
        int blank = open < 0 ? -1 : text.indexOf(' ', open);
        if (blank < 0) {
            position = text.length();
            return "";
        }
        position = blank;
        String tag = text.substring(open + 1, blank);
        tags.add(tag);
        return tag;
    }

    /** Reads one blank and a word behind it. */
    String word() {
        int start = position + 1;
        position = start;
        while (position < text.length() && text.charAt(position) != ' ' && text.charAt(position) != ')') {
            position++;
        }
        return text.substring(start, position);
    }

    /** Reads one blank and a number behind it, digit by digit. */
    double number() {
        int start = position + 1;
        if (text.startsWith("nan", start)) {
            position = start + 3;
            return Double.NaN;
        }
        position = text.charAt(start) == '-' ? start + 1 : start;
        int firstDigit = position;
        while (Character.isDigit(text.charAt(position)) || text.charAt(position) == '.') {
            position++;
        }
        if (position == firstDigit || (text.charAt(position) != ' ' && text.charAt(position) != ')')) {
            throw new AssertionError("\"" + text.substring(start, Math.min(text.length(), start + 20))
                    + "\" is not a number that the agents of FC Portugal understand");
        }
        return Double.parseDouble(text.substring(start, position));
    }

    /** Lists all tags of the message in their order. */
    List<String> allTags() {
        String tag;
        do {
            tag = nextTag();
        } while (!tag.isEmpty());
        return tags.subList(0, tags.size());
    }
}
