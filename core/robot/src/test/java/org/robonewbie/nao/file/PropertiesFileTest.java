package org.robonewbie.nao.file;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class PropertiesFileTest {

    @TempDir
    Path folder = Path.of("");

    @Test
    void readsWhatPropertiesMayLookLike() throws IOException {
        assertThat(read("# a comment\n! another\n\nteam = Red\nnumber:3\nhost 127.0.0.1\n  headless\nreport=a=b c\n"))
                .containsExactlyInAnyOrderEntriesOf(
                        Map.of("team", "Red", "number", "3", "host", "127.0.0.1", "headless", "", "report", "a=b c"));
    }

    @ParameterizedTest
    @CsvSource({
        "UTF-8, '', '\n'",
        "UTF-8, '\uFEFF', '\r\n'",
        "UTF-16LE, '\uFEFF', '\r\n'",
        "UTF-16BE, '\uFEFF', '\r\n'",
        "windows-1252, '', '\r'"
    })
    void fileOfAnyEditorIsRead(String encoding, String mark, String end) throws IOException {
        String text = mark + String.join(end, "team = Red", "# größe", "report = C:/größe.json");
        Path file = Files.write(folder.resolve("robonewbie.properties"), text.getBytes(Charset.forName(encoding)));

        assertThat(PropertiesFile.read(file))
                .containsExactlyInAnyOrderEntriesOf(Map.of("team", "Red", "report", "C:/größe.json"));
    }

    @ParameterizedTest
    @CsvSource({
        "C:\\\\new\\\\tom, C:\\new\\tom",
        "C\\:\\\\new, C:\\new",
        "gr\\u00fcn, grün",
        "\\\\\\\\server\\\\share, \\\\server\\share",
        "C:/new, C:/new"
    })
    void backslashesAreReadAsJavaReadsThem(String written, String value) throws IOException {
        assertThat(read("report = " + written)).containsExactly(Map.entry("report", value));
    }

    @ParameterizedTest
    @CsvSource({
        "C:\\new\\tom.json, C:/new/tom.json, C:\\\\new\\\\tom.json",
        "C:\\users, C:/users, C:\\\\users",
        "C:\\logs\\, C:/logs, C:\\\\logs",
        "\\\\server\\share, //server/share, \\\\\\\\server\\\\share",
        "\\temp, /temp, \\\\temp",
        "C:\\#1, C:/#1, C:\\\\#1"
    })
    void singleBackslashIsRefused(String written, String slashes, String doubled) {
        assertThatThrownBy(() -> read("\nreport = " + written + "\nteam = Red"))
                .isInstanceOf(UnreadableFileException.class)
                .hasMessage(folder.resolve("robonewbie.properties") + ", line 2: In \"" + written
                        + "\", a single backslash would be lost. Write " + slashes + " or " + doubled + ".");
    }

    @Test
    void nameThatStandsTwiceIsRefused() {
        assertThatThrownBy(() -> read("team = Red\nnumber = 3\nteam = Blue\n"))
                .hasMessageEndingWith("line 3: \"team\" is already set in line 1. Delete one of the two lines.");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "team\u00A0= Red",
                "te\u0430m = Red",
                "team = “Red”",
                "seed = \u22125",
                "\u200Bteam = Red",
                "team \uFF1D Red"
            })
    void characterThatLooksLikeAnotherOneIsNamed(String line) {
        assertThatThrownBy(() -> read("seconds = 3\n" + line + "\n"))
                .isInstanceOf(UnreadableFileException.class)
                .hasMessageContaining("robonewbie.properties, line 2: In \"")
                .hasMessageMatching("(?s).* character \\d+ is .* \\(U\\+[0-9A-F]{4}\\): (type|delete) .*");
    }

    @Test
    void fileThatIsNoTextIsRefused() throws IOException {
        Path file = Files.write(folder.resolve("robonewbie.properties"), new byte[] {'a', 0, (byte) 0x81});

        assertThatThrownBy(() -> PropertiesFile.read(file))
                .hasMessageStartingWith("The file " + file + " cannot be read: line 1 ");
    }

    private Map<String, String> read(String text) throws IOException {
        return PropertiesFile.read(Files.writeString(folder.resolve("robonewbie.properties"), text));
    }
}
