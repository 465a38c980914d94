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
import org.robonewbie.programs.completion.PartialWord;
import org.robonewbie.programs.completion.Proposal;
import org.teavm.jso.JSExport;
import org.teavm.jso.typedarrays.Int8Array;

/** Functions that the page's scripts call; each exported method becomes a function of the WebAssembly module. */
public final class CompilerInPage {

    private static final MemoryFiles FILES = new MemoryFiles();
    private static final List<MemoryFile> SOURCES = new ArrayList<>();
    private static final List<Proposal> PROPOSALS = new ArrayList<>();
    private static final List<Compilation.Remark> REMARKS = new ArrayList<>();

    private CompilerInPage() {}

    /**
     * Does nothing; the page calls the exported functions.
     *
     * @param args none
     */
    public static void main(String[] args) {}

    /**
     * Loads the class libraries.
     *
     * @param library concatenated files, each as its name, its size in bytes, and its contents
     * @throws IOException never, because the bytes are in memory
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
     * Adds a source file.
     *
     * @param path its path with extension
     * @param text its text
     */
    @JSExport
    public static void takeSource(String path, String text) {
        SOURCES.add(new MemoryFile(path, text.getBytes(StandardCharsets.UTF_8)));
    }

    /**
     * Compiles the added source files, then removes them.
     *
     * @return the number of diagnostics
     */
    @JSExport
    public static int compile() {
        REMARKS.clear();
        REMARKS.addAll(Compilation.of(FILES, List.copyOf(SOURCES)));
        SOURCES.clear();
        return REMARKS.size();
    }

    /**
     * Returns a diagnostic as tab-separated fields: kind, file, line, start and end index in the source, hint, and
     * message.
     *
     * @param index zero-based index of the diagnostic
     * @return the diagnostic
     */
    @JSExport
    public static String remark(int index) {
        Compilation.Remark said = REMARKS.get(index);
        Diagnostic<? extends JavaFileObject> remark = said.diagnostic();
        String file = remark.getSource() == null ? "" : remark.getSource().getName();
        return remark.getKind() + "\t" + file + "\t" + remark.getLineNumber() + "\t" + remark.getStartPosition() + "\t"
                + remark.getEndPosition() + "\t" + said.hint() + "\t" + remark.getMessage(Locale.ENGLISH);
    }

    /**
     * Computes completion proposals for an added file and removes all added files.
     *
     * @param path path of the file
     * @param at index of the cursor
     * @return the number of proposals
     */
    @JSExport
    public static int complete(String path, int at) {
        PROPOSALS.clear();
        PROPOSALS.addAll(proposals(path, at));
        SOURCES.clear();
        return PROPOSALS.size();
    }

    private static List<Proposal> proposals(String path, int at) {
        List<JavaFileObject> sources = new ArrayList<>();
        String begun = "";
        for (MemoryFile source : SOURCES) {
            if (source.path().equals(path)) {
                PartialWord word = PartialWord.at(source.text(), at);
                begun = word.begun();
                sources.add(0, new MemoryFile(path, word.text().getBytes(StandardCharsets.UTF_8)));
            } else {
                sources.add(source);
            }
        }
        return Compilation.proposals(FILES, sources, begun);
    }

    /**
     * Returns a proposal as tab-separated fields: label, detail, kind, inserted text, and documentation. If the
     * program's own source contains no documentation, that field is empty and two more follow: the class name and the
     * key of the documentation.
     *
     * @param index zero-based index of the proposal
     * @return the proposal
     */
    @JSExport
    public static String proposal(int index) {
        Proposal proposal = PROPOSALS.get(index);
        return String.join(
                "\t",
                proposal.label(),
                proposal.detail(),
                proposal.kind(),
                proposal.insert(),
                proposal.documentation());
    }

    /** {@return the names of the compiled class files, separated by spaces} */
    @JSExport
    public static String classFiles() {
        return String.join(" ", FILES.made().stream().map(MemoryFile::path).toList());
    }

    /**
     * Returns a compiled class file.
     *
     * @param index zero-based index of the class file in the order of {@link #classFiles}
     * @return the class file
     */
    @JSExport
    public static Int8Array classFile(int index) {
        return Int8Array.copyFromJavaArray(FILES.made().get(index).content());
    }
}
