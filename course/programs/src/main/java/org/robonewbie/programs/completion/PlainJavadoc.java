package org.robonewbie.programs.completion;

/** Converts documentation comments to plain text. */
public final class PlainJavadoc {

    private PlainJavadoc() {}

    /**
     * Removes tags and HTML from a documentation comment.
     *
     * @param comment the comment without its delimiters
     * @return plain text
     */
    public static String of(String comment) {
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
