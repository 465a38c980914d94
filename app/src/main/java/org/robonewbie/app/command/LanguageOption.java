package org.robonewbie.app.command;

import org.robonewbie.exercises.Language;
import org.robonewbie.programs.CalledWronglyException;
import picocli.CommandLine.Option;

/** Option {@code --language} for worksheets and hints. */
final class LanguageOption {

    @Option(
            names = "--language",
            paramLabel = "CODE",
            defaultValue = "${env:" + Language.VARIABLE + ":-en}",
            description = "Language of worksheets and hints: en or de (default: $" + Language.VARIABLE + ", else en).")
    private String code = Language.ENGLISH.code();

    Language language() {
        return Language.of(code)
                .orElseThrow(() -> new CalledWronglyException(
                        "There are no worksheets in the language \"" + code + "\". Choose en or de."));
    }
}
