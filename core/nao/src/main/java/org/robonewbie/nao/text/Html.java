package org.robonewbie.nao.text;

/** Writes pages that need no other file. */
public final class Html {

    private Html() {}

    /**
     * Escapes a text for a page.
     *
     * @param plain any text
     * @return the text without signs that mean something in HTML
     */
    public static String text(String plain) {
        return plain.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    /**
     * Writes a page.
     *
     * @param title its title, as plain text
     * @param style its style sheet
     * @param body what stands in it, as HTML
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
