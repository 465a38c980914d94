package org.robonewbie.learning.series;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.Charset;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.robonewbie.nao.file.UnreadableFileException;

class ExperimentPlanTest {

    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource({
        "UTF-8, '', '\n'",
        "UTF-8, '\uFEFF', '\r\n'",
        "UTF-16LE, '\uFEFF', '\r\n'",
        "UTF-16BE, '\uFEFF', '\r'",
        "windows-1252, '', '\r\n'"
    })
    void planOfAnyEditorIsRead(String encoding, String mark, String end) throws IOException {
        String text = mark + String.join(end, "experiment=x", "trials=3", "größe=1,2", "word=\"–ü\"", "");
        Path file = Files.write(folder.resolve("plan.txt"), text.getBytes(Charset.forName(encoding)));

        ExperimentPlan plan = ExperimentPlan.read(file);

        assertThat(plan.experiment()).isEqualTo("x");
        assertThat(plan.trials()).isEqualTo(3);
        assertThat(plan.values()).containsEntry("größe", List.of(1.0, 2.0));
        assertThat(plan.texts()).containsEntry("word", List.of("–ü"));
    }

    @ParameterizedTest
    @CsvSource({
        "'sp\u0435ed=1', 'In \"sp\u0435ed=1\", character 3 is the Cyrillic letter'",
        "'speed\u00A0= 1', 'In \"speed\u00A0= 1\", character 6 is a no-break space (U+00A0)'",
        "'speed = \u22121', 'In \"speed = \u22121\", character 9 is the dash'",
        "word=“x”, 'In \"word=“x”\", character 6 is the quotation mark “'",
        "'speed 1', '\"speed 1\" is not a valid line.'",
        "'speed=1,,2', '\"speed=1,,2\" is not a valid line.'"
    })
    void lineThatIsNotClearIsRefused(String line, String message) throws IOException {
        Path file = Files.writeString(folder.resolve("plan.txt"), "experiment=x\n" + line + "\n");

        assertThatThrownBy(() -> ExperimentPlan.read(file))
                .isInstanceOf(IllegalArgumentException.class)
                .hasMessageStartingWith(file + ", line 2: " + message);
    }

    @Test
    void commentBeginsOutsideOfQuotationMarksOnly() throws IOException {
        Path file = Files.write(
                folder.resolve("plan.txt"),
                List.of("# \"all", "experiment=x # class", "word=\"a#1\",\"b # c\" # \"d\"", "speed=1#2"));

        ExperimentPlan plan = ExperimentPlan.read(file);

        assertThat(plan.experiment()).isEqualTo("x");
        assertThat(plan.texts()).containsEntry("word", List.of("a#1", "b # c"));
        assertThat(plan.values()).containsEntry("speed", List.of(1.0));
    }

    @Test
    void fileThatIsNoTextIsRefused() throws IOException {
        Path file = Files.write(folder.resolve("plan.zip"), new byte[] {'P', 'K', 0, (byte) 0x81});

        assertThatThrownBy(() -> ExperimentPlan.read(file))
                .isInstanceOf(UnreadableFileException.class)
                .hasMessageStartingWith("The file " + file + " cannot be read: line 1 ");
    }
}
