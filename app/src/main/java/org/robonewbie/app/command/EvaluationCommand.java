package org.robonewbie.app.command;

import java.nio.file.Path;
import java.util.concurrent.Callable;
import org.robonewbie.exercises.marking.EvaluationSummary;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** Summarises a course's evaluation forms. */
@Command(
        name = "evaluation",
        description = "Summarise the evaluation forms of a course, grouped by the participants' experience.",
        footer = {
            "",
            "Examples:",
            "  robonewbie evaluation answers.csv",
            "The form is in docs/teaching/evaluation-form.md."
        })
final class EvaluationCommand implements Callable<Integer> {

    @Mixin
    final HelpOption help = new HelpOption();

    @Parameters(
            paramLabel = "FILE",
            description =
                    "CSV table: a line with the names of the questions, then a line of numbers for each participant.")
    private Path file = Path.of("");

    @Override
    public Integer call() {
        System.out.print(EvaluationSummary.of(file));
        return ExitCode.OK;
    }
}
