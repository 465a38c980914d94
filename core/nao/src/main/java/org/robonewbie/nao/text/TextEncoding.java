package org.robonewbie.nao.text;

/** The encodings in which text editors, spreadsheets and shells save files today. */
public enum TextEncoding {
    /** What nearly every editor writes. */
    UTF_8("UTF-8"),
    /** Windows PowerShell and Excel ("Unicode text"); always with a byte order mark. */
    UTF_16_LE("UTF-16LE"),
    /** The same with the bytes swapped; always with a byte order mark. */
    UTF_16_BE("UTF-16BE"),
    /** Old Windows editors, NetBeans and Excel in western Europe; also reads Latin-1. */
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
