package org.robonewbie.app.course;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;

class EvaluationSummaryTest {

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

    @Test
    void wrongLineIsNamed() {
        assertThatThrownBy(() -> EvaluationSummary.of(List.of("robotics,java", "1,3", "1,9")))
                .hasMessage("Line 3: \"9\" is no answer. Answers go from 1 to 5.");
        assertThatThrownBy(() -> EvaluationSummary.of(List.of("robotics,java", "1")))
                .hasMessage("Line 2 has 1 answers, but there are 2 questions.");
    }

    @Test
    void missingFileIsToldInASentence() {
        assertThatThrownBy(() -> EvaluationSummary.of(Path.of("no-such.csv")))
                .hasMessage("The file no-such.csv cannot be read. Is its name right?");
    }
}
