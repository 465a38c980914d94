package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HexFormat;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Saving in the program editor changes only the edited bytes, in any encoding. */
@Tag("slow")
@InBrowser
@Timeout(300)
class ProgramEncodingPageTest {

    private static final String PROGRAM = "// Grüße\r\npublic class Lat {\r\n    // ß\r\n}\r\n";
    private static final String FILE = "studio.rooms.program?.files?.file";
    private static final String NOTE = "document.querySelector('#program-encoding').innerText";

    @TempDir
    private Path folder;

    private final Chromium browser;
    private FurnishedStudio studio;

    ProgramEncodingPageTest(Chromium browser) {
        this.browser = browser;
    }

    @BeforeEach
    void open() throws IOException {
        studio = new FurnishedStudio(folder);
    }

    @AfterEach
    void close() {
        studio.close();
    }

    static byte[] bytes(String mark, String charset, String text) {
        ByteArrayOutputStream bytes = new ByteArrayOutputStream();
        bytes.writeBytes(HexFormat.of().parseHex(mark));
        bytes.writeBytes(text.getBytes(Charset.forName(charset)));
        return bytes.toByteArray();
    }

    private Path visit(byte[] bytes) throws IOException {
        Path file = Files.write(folder.resolve("Lat.java"), bytes);
        browser.visit(studio.oneTimeAddress() + "&theme=light&quality=lowest#program/Lat.java");
        browser.await(FILE + "?.path === 'Lat.java'");
        return file;
    }

    private void typeAndSave(String typed) {
        browser.evaluate("(({ view }) => { view.focus();"
                + " view.dispatch({ changes: { from: view.state.doc.length, insert: " + Chromium.quoted(typed)
                + " }, userEvent: 'input.type' }); })(studio.rooms.program.editor)");
        browser.press("s", 2);
        browser.await("document.querySelector('#program-save').disabled && " + FILE + ".saved.endsWith("
                + Chromium.quoted(typed) + ")");
    }

    @ParameterizedTest
    @CsvSource({"windows-1252,''", "ISO-8859-1,''", "UTF-8,''", "UTF-8,EFBBBF", "UTF-16LE,FFFE", "UTF-16BE,FEFF"})
    void onlyTypedTextChanges(String charset, String mark) throws IOException {
        Path file = visit(bytes(mark, charset, PROGRAM));

        assertThat(browser.evaluate("studio.rooms.program.editor.text").getAsString())
                .isEqualTo(PROGRAM.replace("\r\n", "\n"));
        typeAndSave("// x");

        assertThat(file).hasBinaryContent(bytes(mark, charset, PROGRAM + "// x"));
        assertThat(browser.complaints()).isEmpty();
    }

    @Test
    void inferredEncodingIsShownAndCanBeChanged() throws IOException {
        Path file = visit(bytes("", "windows-1252", PROGRAM));

        browser.await(NOTE + ".includes('line 1 is not UTF-8 and was read as Windows-1252: \"// Grüße\"')");
        browser.click("#program-encoding button");
        browser.await(NOTE + ".includes('Lat.java is now saved as UTF-8') || " + NOTE + " === ''");

        studio.simulation().awaitTrue(() -> hasContent(file, bytes("", "UTF-8", PROGRAM)));
        typeAndSave("// ä");
        assertThat(file).hasBinaryContent(bytes("", "UTF-8", PROGRAM + "// ä"));
    }

    private static boolean hasContent(Path file, byte[] bytes) {
        try {
            return java.util.Arrays.equals(Files.readAllBytes(file), bytes);
        } catch (IOException beingWritten) {
            return false;
        }
    }

    @Test
    void unencodableCharacterConvertsTheFileToUtf8() throws IOException {
        Path file = visit(bytes("", "windows-1252", PROGRAM));

        typeAndSave("// Привет");

        browser.await(
                NOTE
                        + ".includes('Lat.java is now saved as UTF-8, because Windows-1252 cannot represent all of its characters')");
        assertThat(file).hasBinaryContent((PROGRAM + "// Привет").getBytes(StandardCharsets.UTF_8));
    }

    @ParameterizedTest
    @CsvSource({
        "6F6B0A8161,line 2 is neither UTF-8 nor Windows-1252",
        "C3BCC3BC0AFF,line 2 is not UTF-8",
        "61006200,zero byte",
        "FFFE610A00,ends within a UTF-16 character"
    })
    void undecodableFileIsReadOnly(String hex, String problem) throws IOException {
        byte[] bytes = HexFormat.of().parseHex(hex);
        Path file = visit(bytes);

        browser.await(NOTE + ".includes(" + Chromium.quoted(problem) + ")");
        browser.evaluate("studio.rooms.program.editor.view.focus()");
        browser.press("x");
        browser.press("s", 2);
        browser.click("#program-run");
        browser.await("document.querySelector('#program-save').disabled");

        assertThat(browser.evaluate("studio.rooms.program.editor.view.state.readOnly")
                        .getAsBoolean())
                .isTrue();
        assertThat(file).hasBinaryContent(bytes);
        assertThat(folder.resolve(".studio").resolve("programs")).doesNotExist();
    }
}
