package org.robonewbie.app.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.robonewbie.app.course.Coach;
import org.robonewbie.app.course.ProgressTable;
import org.robonewbie.exercises.progress.Progress;
import org.robonewbie.exercises.progress.ProgressFile;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.programs.CalledWronglyException;
import picocli.CommandLine.Command;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** Shows how far a student or a team is with the exercises. */
@Command(
        name = "progress",
        description = {
            "Show how far you are with the exercises: passed, best points, tries, time of work, badges.",
            "Your progress is one file, .robonewbie/progress.json in your home folder; it never leaves the computer by itself."
                    + " The environment variable " + ProgressFile.SWITCH + " names another file, or \"off\"."
        },
        footer = {
            "",
            "Examples:",
            "  robonewbie progress",
            "  robonewbie progress --csv anna.csv --name Anna     the table for your teacher",
            "  robonewbie progress anna.json ben.json             the progress of a team: each exercise counts once"
        })
final class ProgressCommand implements Callable<Integer> {

    @Mixin
    final HelpOption help = new HelpOption();

    @Parameters(
            arity = "0..*",
            paramLabel = "FILE",
            description = "Progress files of a team's members (default: your own).")
    private List<Path> files = List.of();

    @Option(names = "--csv", paramLabel = "FILE", description = "Write a table with commas for the teacher.")
    private Optional<Path> csv = Optional.empty();

    @Option(
            names = "--name",
            paramLabel = "NAME",
            description = "Whose progress it is in the table (default: your account).")
    private String name = System.getProperty("user.name", "");

    @Override
    public Integer call() throws IOException {
        ProgressTable table = new ProgressTable(files.isEmpty() ? Coach.ofUser().progress() : team());
        System.out.print(table.text());
        if (csv.isPresent()) {
            AtomicFile.write(csv.get(), table.csv(name));
            System.out.println("Written: " + csv.get());
        }
        return ExitCode.OK;
    }

    private Progress team() throws IOException {
        Progress team = new Progress(Map.of());
        for (Path file : files) {
            if (!Files.isRegularFile(file)) {
                throw new CalledWronglyException("There is no file " + file
                        + ". Each member of the team has one: .robonewbie/progress.json in the home folder.");
            }
            ProgressFile member = new ProgressFile(file);
            if (member.isDamaged()) {
                System.err.println("The file " + file + " is damaged or holds no progress, and counts as empty.");
            }
            team = team.joined(member.read());
        }
        return team;
    }
}
