package org.robonewbie.site;

import java.nio.file.Path;
import java.util.Locale;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Exercises;
import org.robonewbie.exercises.Language;

/** Adds the content that is derived from an exercise to its worksheet: goal, commands, times and links. */
final class WorksheetTemplate {

    private static final Path FOLDER = Path.of("docs", "exercises");

    private static final String ENGLISH = """
            {{title}}

            **Goal**: {{goal}}

            {{introduction}}

            ## Begin

            ```sh
            ./robonewbie grade {{name}} --start  # write {{file}}
            ./robonewbie grade {{name}} {{file}} --watch  # grade it and watch
            ./robonewbie grade {{name}} {{file}} --seeds 10  # ten seeds instead of three
            ```

            The exercise takes about {{minutes}} minutes, a trial up to {{seconds}} seconds.

            {{sections}}

            [All exercises](README.md) · [Auf Deutsch](de/{{sheet}})
            """;

    private static final String GERMAN = """
            {{title}}

            **Ziel**: {{goal}}

            {{introduction}}

            ## Beginnen

            ```sh
            ./robonewbie grade {{name}} --start  # schreibt {{file}}
            ./robonewbie grade {{name}} {{file}} --language de --watch  # bewerten und zusehen
            ./robonewbie grade {{name}} {{file}} --language de --seeds 10  # zehn Startzahlen statt drei
            ```

            Die Aufgabe dauert etwa {{minutes}} Minuten, ein Versuch bis zu {{seconds}} Sekunden.

            {{sections}}

            [Alle Aufgaben](README.md) · [In English](../{{sheet}})
            """;

    private WorksheetTemplate() {}

    /** Returns the completed text of a worksheet; returns any other page unchanged. */
    static String fill(Path page, String markdown) {
        for (Language language : Language.values()) {
            for (Exercise exercise : Exercises.all()) {
                if (page.endsWith(FOLDER.resolve(language.worksheet(exercise) + ".md"))) {
                    return fill(exercise, language, markdown);
                }
            }
        }
        return markdown;
    }

    private static String fill(Exercise exercise, Language language, String markdown) {
        int title = markdown.indexOf("\n\n");
        int sections = markdown.indexOf("## ", title);
        return (language == Language.GERMAN ? GERMAN : ENGLISH)
                .replace("{{title}}", markdown.substring(0, title))
                .replace("{{goal}}", language.translated(exercise.goal()))
                .replace("{{introduction}}", markdown.substring(title, sections).strip())
                .replace("{{name}}", exercise.name())
                .replace("{{file}}", exercise.fileName())
                .replace("{{minutes}}", Integer.toString(exercise.minutes()))
                .replace("{{seconds}}", String.format(Locale.ROOT, "%.0f", exercise.seconds()))
                .replace("{{sheet}}", exercise.fullName() + ".md")
                .replace("{{sections}}", markdown.substring(sections).strip());
    }
}
