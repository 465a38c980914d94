package org.robonewbie.app.studio;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.robonewbie.exercises.Exercise;
import org.robonewbie.exercises.Grade;
import org.robonewbie.exercises.service.CourseHost;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.studio.ShownSimulation;

/** Runs attempts with the programs in a student's folder, and shows them in the studio in place of the free pitch. */
public class LocalCourseHost implements CourseHost {

    private final Path folder;
    private final SimulationControl freePitch;
    private final ShownSimulation shown;
    private Optional<CourseAttempt> current = Optional.empty();

    /**
     * Creates the host.
     *
     * @param folder folder of the student's programs
     * @param freePitch simulation that is shown while no attempt is running
     * @param shown the displayed simulation
     */
    public LocalCourseHost(Path folder, SimulationControl freePitch, ShownSimulation shown) {
        this.folder = folder;
        this.freePitch = freePitch;
        this.shown = shown;
    }

    @Override
    public List<String> programs() {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> String.valueOf(file.getFileName()))
                    .filter(name -> name.endsWith(".java"))
                    .sorted()
                    .toList();
        } catch (IOException unreadable) {
            return List.of();
        }
    }

    @Override
    public boolean create(String file, String text) throws IOException {
        Path created = folder.resolve(file);
        if (Files.exists(created)) {
            return false;
        }
        AtomicFile.write(created, text);
        return true;
    }

    @Override
    public CourseAttempt begin(Exercise exercise, long id, String program, int trials, Consumer<Grade> judged)
            throws IOException {
        current.ifPresent(CourseAttempt::close);
        CourseAttempt attempt = new CourseAttempt(id, exercise, program, trials, folder, shown::show, judged);
        attempt.start();
        current = Optional.of(attempt);
        return attempt;
    }

    @Override
    public void showFreePitch() {
        shown.show(freePitch);
    }
}
