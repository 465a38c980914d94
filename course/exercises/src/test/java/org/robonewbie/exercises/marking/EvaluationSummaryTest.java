package org.robonewbie.exercises.marking;

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

class EvaluationSummaryTest {

    @TempDir
    Path folder = Path.of("");

    @Test
    void meansAreToldForAllAndByExperience() {
        String summary = EvaluationSummary.of(List.of("robotics,java,usage", "1,3,5", "4,5,4", "2,4,2", ""))
                .toString();

        assertThat(summary.lines().map(line -> line.replaceAll(" +", " ")))
                .containsExactly(
                        "experience people robotics java usage",
                        "all 3 2.33 4.00 3.67",
                        "robotics little 2 1.50 3.50 3.50",
                        "robotics some 0 - - -",
                        "robotics much 1 4.00 5.00 4.00",
                        "java little 0 - - -",
                        "java some 1 1.00 3.00 5.00",
                        "java much 2 3.00 4.50 3.00");
    }

    @ParameterizedTest
    @CsvSource({
        "UTF-8, '\uFEFF', ',', '\r\n', ''",
        "UTF-16LE, '\uFEFF', '\t', '\r\n', ''",
        "windows-1252, '', ';', '\r\n', '\"'",
        "UTF-8, '', ',', '\r', ''"
    })
    void tableOfAnySpreadsheetIsRead(String encoding, String mark, String separator, String end, String quote)
            throws IOException {
        String text = mark
                + "robotics,Java,größe\n1,3,5\n4,5,4\n"
                        .replaceAll("[\\wöß]+", quote + "$0" + quote)
                        .replace(",", separator)
                        .replace("\n", end);
        Path file = Files.write(folder.resolve("answers.csv"), text.getBytes(Charset.forName(encoding)));

        assertThat(EvaluationSummary.of(file).toString().lines().map(line -> line.replaceAll(" +", " ")))
                .contains("robotics little 1 1.00 3.00 5.00", "java much 1 4.00 5.00 4.00");
    }

    @Test
    void missingColumnIsNamed() {
        assertThat(EvaluationSummary.of(List.of("java,usage", "1,3")).toString())
                .contains("There is no column \"robotics\", so the answers are not grouped by it.");
    }

    @Test
    void directionOfTheProportionIsExplained() {
        assertThat(EvaluationSummary.of(List.of("proportion", "4", "5")).toString())
                .contains(
                        "4.50",
                        "proportion: 1 = much more lecture, 3 = the proportion of the course, 5 = much more exercise");
    }

    @Test
    void headThatIsNotClearIsRefused() {
        assertThatThrownBy(() -> EvaluationSummary.of(List.of("robotics\u00A0,java", "1,3")))
                .hasMessageStartingWith("Line 1: in ")
                .hasMessageContaining("character 9 is a no-break space");
        assertThatThrownBy(() -> EvaluationSummary.of(List.of("java,Java", "1,3")))
                .hasMessage("Line 1: two questions have the same name. Rename one of them.");
    }

    @Test
    void fileThatIsNoTextIsRefused() throws IOException {
        Path file = Files.write(folder.resolve("answers.xls"), new byte[] {(byte) 0xD0, (byte) 0xCF, 0x11, 0, 0});

        assertThatThrownBy(() -> EvaluationSummary.of(file))
                .hasMessageStartingWith("The file " + file + " cannot be read: line 1 ");
    }

    @Test
    void wrongLineOfAFileIsNamedWithTheFile() throws IOException {
        Path file = Files.writeString(folder.resolve("answers.csv"), "robotics,java\n1,3\n1,9\n");

        assertThatThrownBy(() -> EvaluationSummary.of(file))
                .hasMessage(file + ": Line 3: \"9\" is not an answer. Answers are numbers from 1 to 5.");
    }

    @Test
    void wrongLineIsNamed() {
        assertThatThrownBy(() -> EvaluationSummary.of(List.of("robotics,java", "1,3", "1,9")))
                .hasMessage("Line 3: \"9\" is not an answer. Answers are numbers from 1 to 5.");
        assertThatThrownBy(() -> EvaluationSummary.of(List.of("robotics,java", "1")))
                .hasMessage("Line 2 has 1 answers, but there are 2 questions.");
    }

    @Test
    void missingFileIsToldInASentence() {
        assertThatThrownBy(() -> EvaluationSummary.of(Path.of("no-such.csv")))
                .hasMessage("The file no-such.csv does not exist in the folder "
                        + Path.of("").toAbsolutePath() + ". Check the name.");
    }
}
