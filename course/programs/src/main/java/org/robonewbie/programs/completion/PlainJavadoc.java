package org.robonewbie.programs.completion;

/** Documentation comments as plain text. */
final class PlainJavadoc {

    private PlainJavadoc() {}

    /**
     * Takes away what is meant for browsers.
     *
     * @param comment a documentation comment without its stars
     * @return its text
     */
    static String of(String comment) {
        return comment.replaceAll("\\{@return\\s+([^}]*)\\}", "Returns $1.")
                .replaceAll("(?s)<pre>\\{@code(.*?)\\}</pre>", "$1")
                .replaceAll("\\{@link(?:plain)?\\s+(?:[^}\\s]*\\s+)?([^}]*)\\}", "$1")
                .replaceAll("\\{@\\w+\\s+([^}]*)\\}", "$1")
                .replaceAll("(?m)^\\s*@param\\s+(\\S+)\\s+", "$1: ")
                .replaceAll("(?m)^\\s*@return\\s+", "returns ")
                .replaceAll("(?m)^\\s*@throws\\s+(\\S+)\\s+", "throws $1: ")
                .replaceAll("</?\\w+[^>]*>", "")
                .replace("&lt;", "<")
                .replace("&gt;", ">")
                .replace("&amp;", "&")
                .replaceAll("(?m)^ ", "")
                .strip();
    }
}
