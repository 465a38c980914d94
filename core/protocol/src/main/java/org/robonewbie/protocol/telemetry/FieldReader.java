package org.robonewbie.protocol.telemetry;

import org.robonewbie.nao.Vector3;

/** Parses tab-separated fields. Throws {@link IllegalArgumentException} if a field is missing or not a number. */
final class FieldReader {

    private final String[] fields;
    private int next;

    FieldReader(String line) {
        fields = line.split("\t", -1);
    }

    boolean hasMore() {
        return next < fields.length;
    }

    String text() {
        if (!hasMore()) {
            throw new IllegalArgumentException("a field is missing");
        }
        String field = fields[next++];
        return field.indexOf('\\') < 0 ? field : unescaped(field);
    }

    double number() {
        return Double.parseDouble(text());
    }

    Vector3 vector() {
        return new Vector3(number(), number(), number());
    }

    private static String unescaped(String field) {
        StringBuilder text = new StringBuilder(field.length());
        for (int i = 0; i < field.length(); i++) {
            char character = field.charAt(i);
            if (character == '\\' && i + 1 < field.length()) {
                i++;
                character = switch (field.charAt(i)) {
                    case 't' -> '\t';
                    case 'n' -> '\n';
                    case 'r' -> '\r';
                    default -> field.charAt(i);
                };
            }
            text.append(character);
        }
        return text.toString();
    }
}
