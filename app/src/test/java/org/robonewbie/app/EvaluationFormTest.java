package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.robonewbie.exercises.marking.EvaluationSummary;

/** The evaluation form, in English and in German, asks the questions that its example file answers. */
class EvaluationFormTest {

    private static final Pattern QUESTION = Pattern.compile("(?m)^\\| (\\w+) \\| [^|]+ \\| \\|$");
    private static final Pattern EXAMPLE = Pattern.compile("(?ms)^```csv\\R(.*?)^```");

    private final String form = Project.read(Project.ROOT.resolve("docs/teaching/evaluation-form.md"));
    private final String example =
            EXAMPLE.matcher(form).results().findFirst().orElseThrow().group(1);

    @Test
    void bothLanguagesAskTheSameQuestions() {
        List<String> questions =
                List.of(example.lines().findFirst().orElseThrow().split(",", -1));

        assertThat(QUESTION.matcher(form).results().map(row -> row.group(1)))
                .containsExactlyElementsOf(
                        Stream.concat(questions.stream(), questions.stream()).toList());
    }

    @Test
    void exampleIsSummarised(@TempDir Path folder) throws IOException {
        Path answers = Files.writeString(folder.resolve("answers.csv"), example);

        assertThat(EvaluationSummary.of(answers).toString())
                .contains("experiments", "proportion: 1 = much more lecture");
    }
}
