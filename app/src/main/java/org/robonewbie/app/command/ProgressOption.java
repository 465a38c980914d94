package org.robonewbie.app.command;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robonewbie.exercises.progress.Progress;
import org.robonewbie.exercises.progress.ProgressFile;
import org.robonewbie.exercises.progress.ProgressService;
import org.robonewbie.exercises.progress.ProgressTable;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.programs.CalledWronglyException;
import picocli.CommandLine.ExitCode;
import picocli.CommandLine.Option;

/** The options of {@code grade} that show the progress of a student or a team. */
final class ProgressOption {

    private static final Path OWN = Path.of("-");

    @Option(
            names = "--progress",
            arity = "0..*",
            fallbackValue = "-",
            paramLabel = "FILE",
            description = {
                "Show your progress: passed exercises, best points, attempts, working time, badges. Given the progress"
                        + " files of a team's members, show the team's progress instead.",
                "Your file is .robonewbie/progress.json in your home folder; it is never sent anywhere. The environment variable "
                        + ProgressFile.SWITCH + " selects another file; if it is \"off\", no progress is stored."
            })
    private List<Path> files = List.of();

    @Option(names = "--csv", paramLabel = "FILE", description = "With --progress: write a table for the teacher.")
    private Optional<Path> csv = Optional.empty();

    @Option(
            names = "--name",
            paramLabel = "NAME",
            description = "With --progress: the name in the table (default: your account name).")
    private String name = System.getProperty("user.name", "");

    boolean isGiven() {
        return !files.isEmpty();
    }

    int show() throws IOException {
        ProgressTable table =
                new ProgressTable(files.contains(OWN) ? ProgressService.ofUser().progress() : team());
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
                        + ". Each team member's file is .robonewbie/progress.json in the home folder.");
            }
            ProgressFile member = new ProgressFile(file);
            if (member.isDamaged()) {
                System.err.println("The file " + file + " is damaged or not a progress file, and is treated as empty.");
            }
            team = team.joined(member.read());
        }
        return team;
    }
}
