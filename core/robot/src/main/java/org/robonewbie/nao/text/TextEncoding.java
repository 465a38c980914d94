package org.robonewbie.nao.text;

/** The text encodings in which editors, spreadsheets and shells save files. */
public enum TextEncoding {
    /** The default in nearly every editor. */
    UTF_8("UTF-8"),
    /** Written by Windows PowerShell and Excel ("Unicode text"); always with a byte order mark. */
    UTF_16_LE("UTF-16LE"),
    /** UTF-16 in big-endian byte order; always with a byte order mark. */
    UTF_16_BE("UTF-16BE"),
    /** Written by old Windows editors, NetBeans and Excel in Western Europe; a superset of printable Latin-1. */
    WINDOWS_1252("Windows-1252");

    private final String title;

    TextEncoding(String title) {
        this.title = title;
    }

    /** {@return the registered name, such as {@code UTF-8}} */
    @Override
    public String toString() {
        return title;
    }
}
