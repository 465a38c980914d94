package org.robonewbie.nao.text;

/** Self-contained HTML pages. */
public final class Html {

    private Html() {}

    /**
     * Escapes text for HTML.
     *
     * @param plain any text
     * @return the text with HTML special characters escaped
     */
    public static String text(String plain) {
        return plain.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    /**
     * Creates a page.
     *
     * @param title title, as plain text
     * @param style style sheet
     * @param body body, as HTML
     * @return the page
     */
    public static String page(String title, String style, String body) {
        return """
            <!DOCTYPE html>
            <html lang="en">
            <head>
            <meta charset="utf-8">
            <meta name="viewport" content="width=device-width, initial-scale=1">
            <title>%s</title>
            <style>
            %s</style>
            </head>
            <body>
            %s</body>
            </html>
            """.formatted(text(title), style, body);
    }
}
