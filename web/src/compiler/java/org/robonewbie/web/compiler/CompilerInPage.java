package org.robonewbie.web.compiler;

import java.io.ByteArrayInputStream;
import java.io.DataInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import javax.tools.Diagnostic;
import javax.tools.JavaFileObject;
import org.teavm.jso.JSExport;
import org.teavm.jso.typedarrays.Int8Array;

/** What the scripts of the page call; each exported method becomes a function of the compiled program. */
public final class CompilerInPage {

    private static final MemoryFiles FILES = new MemoryFiles();
    private static final List<JavaFileObject> SOURCES = new ArrayList<>();
    private static final List<Diagnostic<? extends JavaFileObject>> REMARKS = new ArrayList<>();

    private CompilerInPage() {}

    /**
     * Does nothing: the page calls the functions.
     *
     * @param args none
     */
    public static void main(String[] args) {}

    /**
     * Takes the class libraries.
     *
     * @param library file after file: its name, the number of its bytes, and these
     * @throws IOException never
     */
    @JSExport
    public static void takeLibrary(Int8Array library) throws IOException {
        takeLibrary(library.copyToJavaArray());
    }

    static void takeLibrary(byte[] library) throws IOException {
        DataInputStream input = new DataInputStream(new ByteArrayInputStream(library));
        int files = input.readInt();
        for (int i = 0; i < files; i++) {
            String path = input.readUTF();
            byte[] content = new byte[input.readInt()];
            input.readFully(content);
            FILES.add(path, content);
        }
    }

    /**
     * Takes a file with Java.
     *
     * @param path its name with folders and ending
     * @param text its text
     */
    @JSExport
    public static void takeSource(String path, String text) {
        SOURCES.add(new MemoryFile(path, text.getBytes(StandardCharsets.UTF_8)));
    }

    /**
     * Compiles the files that were taken, and forgets them.
     *
     * @return the number of remarks
     */
    @JSExport
    public static int compile() {
        REMARKS.clear();
        REMARKS.addAll(Compilation.of(FILES, SOURCES));
        SOURCES.clear();
        return REMARKS.size();
    }

    /**
     * Returns a remark as tab-separated words: kind, file, line, column, first and last character of the place, javac's name for it, and
     * the text.
     *
     * @param index from 0
     * @return the remark
     */
    @JSExport
    public static String remark(int index) {
        Diagnostic<? extends JavaFileObject> remark = REMARKS.get(index);
        String file = remark.getSource() == null ? "" : remark.getSource().getName();
        return remark.getKind() + "\t" + file + "\t" + remark.getLineNumber() + "\t" + remark.getColumnNumber() + "\t"
                + remark.getStartPosition() + "\t" + remark.getEndPosition() + "\t" + remark.getCode() + "\t"
                + remark.getMessage(Locale.ENGLISH);
    }

    /** {@return the names of the class files that were made, separated by blanks} */
    @JSExport
    public static String classFiles() {
        return String.join(
                " ", FILES.made().stream().map(MemoryFile::path).toList());
    }

    /**
     * Returns a class that was made.
     *
     * @param index from 0, in the order of {@link #classFiles}
     * @return the class file
     */
    @JSExport
    public static Int8Array classFile(int index) {
        return Int8Array.copyFromJavaArray(FILES.made().get(index).content());
    }
}
