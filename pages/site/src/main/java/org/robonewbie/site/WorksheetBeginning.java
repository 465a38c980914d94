package org.robonewbie.site;

import java.nio.file.Path;
import java.util.Locale;
import java.util.regex.Matcher;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.Language;

/** Section <em>Begin</em> of the worksheets: commands, working time and length of a trial, all taken from the exercise. */
final class WorksheetBeginning {

    private static final String ENGLISH = """
            ## Begin

            ```sh
            ./robonewbie grade %1$s --start  # write %2$s
            ./robonewbie grade %1$s %2$s --watch  # grade it with three seeds and watch the first trial
            ./robonewbie grade %1$s %2$s --seeds 10  # grade it with ten seeds
            ```

            The exercise takes about %3$d minutes, a trial up to %4$.0f seconds.

            """;

    private static final String GERMAN = """
            ## Beginnen

            ```sh
            ./robonewbie grade %1$s --start  # schreibt %2$s
            ./robonewbie grade %1$s %2$s --language de --watch  # bewertet es mit drei Startzahlen und zeigt den ersten Versuch
            ./robonewbie grade %1$s %2$s --language de --seeds 10  # bewertet es mit zehn Startzahlen
            ```

            Die Aufgabe dauert etwa %3$d Minuten, ein Versuch bis zu %4$.0f Sekunden.

            """;

    private WorksheetBeginning() {}

    /** Inserts the section before the first one of a worksheet; other pages are unchanged. */
    static String insertedInto(String markdown, Path page) {
        for (Language language : Language.values()) {
            for (Exercise exercise : Exercises.all()) {
                if (page.endsWith(Path.of("docs", "exercises").resolve(language.worksheet(exercise) + ".md"))) {
                    String section = of(exercise, language);
                    return markdown.replaceFirst("(?m)^## ", Matcher.quoteReplacement(section) + "$0");
                }
            }
        }
        return markdown;
    }

    private static String of(Exercise exercise, Language language) {
        return String.format(
                Locale.ROOT,
                language == Language.GERMAN ? GERMAN : ENGLISH,
                exercise.name(),
                exercise.fileName(),
                exercise.minutes(),
                exercise.seconds());
    }
}
