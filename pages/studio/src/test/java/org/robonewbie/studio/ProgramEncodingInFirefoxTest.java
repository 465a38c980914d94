package org.robonewbie.studio;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;

/** {@link ProgramEncodingPageTest} in a real Firefox. */
@Tag("slow")
@Timeout(300)
class ProgramEncodingInFirefoxTest {

    private static final String FILE = "studio.rooms.program.files.file";
    private static final String PROGRAM = "public class Lat {\r\n    // üß\r\n}\r\n";

    @TempDir
    private Path folder;

    @TempDir
    private Path profile;

    @Test
    void latin1StaysLatin1AndUndecodableBytesStay() throws IOException {
        Path latin = Files.write(folder.resolve("Lat.java"), ProgramEncodingPageTest.bytes("", "ISO-8859-1", PROGRAM));
        Path damaged = Files.write(folder.resolve("Odd.java"), new byte[] {'o', 'k', '\n', (byte) 0x81});

        try (Firefox browser = Firefox.start(profile);
                FurnishedStudio studio = new FurnishedStudio(folder)) {
            browser.visit(studio.oneTimeAddress() + "&theme=light&quality=lowest#program/Lat.java");
            browser.await(FILE + "?.path === 'Lat.java'");
            browser.evaluate(
                    "(({ view }) => { view.focus();"
                            + " view.dispatch({ selection: { anchor: view.state.doc.length } }); })(studio.rooms.program.editor)");
            browser.type("// x");
            browser.await("studio.rooms.program.editor.text.endsWith('// x')");
            browser.typeWithControl("s");
            browser.await(FILE + ".saved.endsWith('// x')");

            assertThat(latin).hasBinaryContent(ProgramEncodingPageTest.bytes("", "ISO-8859-1", PROGRAM + "// x"));

            browser.evaluate("location.hash = '#program/Odd.java'");
            browser.await("document.querySelector('#program-encoding').innerText.includes('line 2 is neither UTF-8')");
            browser.evaluate("studio.rooms.program.editor.view.focus()");
            browser.type("x");
            browser.typeWithControl("s");

            assertThat(browser.evaluate("studio.rooms.program.editor.text.startsWith('ok')")
                            .getAsBoolean())
                    .isTrue();
            assertThat(damaged).hasBinaryContent(new byte[] {'o', 'k', '\n', (byte) 0x81});
        }
    }
}
