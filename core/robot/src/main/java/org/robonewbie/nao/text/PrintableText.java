package org.robonewbie.nao.text;

/**
 * Escapes untrusted text for a terminal or a log, so that it stays on one line and cannot move the cursor, change colours or
 * reverse the writing direction.
 */
public final class PrintableText {

    private PrintableText() {}

    /**
     * Escapes control characters.
     *
     * @param text a name or a line
     * @return the text with {@code \n} for a line feed, {@code \u001B} for an escape and so on
     */
    public static String of(String text) {
        StringBuilder shown = new StringBuilder(text.length());
        text.codePoints().forEach(character -> append(shown, character));
        return shown.toString();
    }

    private static void append(StringBuilder shown, int character) {
        switch (character) {
            case '\n' -> shown.append("\\n");
            case '\r' -> shown.append("\\r");
            case '\t' -> shown.append("\\t");
            default -> {
                if (isInvisible(character)) {
                    shown.append(String.format("\\u%04X", character));
                } else {
                    shown.appendCodePoint(character);
                }
            }
        }
    }

    private static boolean isInvisible(int character) {
        byte direction = Character.getDirectionality(character);
        int kind = Character.getType(character);
        return Character.isISOControl(character)
                || kind == Character.LINE_SEPARATOR
                || kind == Character.PARAGRAPH_SEPARATOR
                || kind == Character.SURROGATE
                || (direction >= Character.DIRECTIONALITY_LEFT_TO_RIGHT_EMBEDDING
                        && direction <= Character.DIRECTIONALITY_POP_DIRECTIONAL_FORMAT)
                || (direction >= Character.DIRECTIONALITY_LEFT_TO_RIGHT_ISOLATE
                        && direction <= Character.DIRECTIONALITY_POP_DIRECTIONAL_ISOLATE);
    }
}
