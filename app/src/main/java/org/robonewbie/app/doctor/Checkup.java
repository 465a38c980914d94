package org.robonewbie.app.doctor;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Supplier;
import org.robonewbie.nao.file.PathEncoding;

/** All checks of the installation, from the Java version to a short simulation. */
public final class Checkup {

    private final List<Supplier<Finding>> checks = new ArrayList<>();

    private Checkup() {}

    /**
     * Returns the checks of an installation.
     *
     * @param headless whether to skip the studio and the browser
     * @return the checks, not yet run
     */
    public static Checkup of(boolean headless) {
        Checkup checkup = new Checkup();
        checkup.checks.add(JavaCheck::version);
        checkup.checks.add(EncodingCheck::ofNames);
        if (PathEncoding.problem().isPresent()) {
            return checkup;
        }
        checkup.checks.add(JavaCheck::compiler);
        checkup.checks.add(JavaCheck::memory);
        checkup.checks.add(JavaCheck::mathematics);
        checkup.checks.add(() -> FolderCheck.of("This folder", Path.of("").toAbsolutePath()));
        checkup.checks.add(() -> FolderCheck.of("Home folder", Path.of(System.getProperty("user.home", "."))));
        checkup.checks.add(() -> PortCheck.of("Agent port", 3100));
        checkup.checks.add(() -> PortCheck.of("Monitor port", 3200));
        checkup.checks.add(SimulatorCheck::oneSecond);
        checkup.checks.add(LeagueCheck::server);
        if (!headless) {
            checkup.checks.add(StudioCheck::page);
            checkup.checks.add(BrowserCheck::command);
        }
        return checkup;
    }

    /**
     * Returns the checks of a classroom computer.
     *
     * @param headless whether to skip the studio, the browser and the graphics
     * @return the checks of the installation, and of everything else that a lesson needs
     */
    public static Checkup ofRoom(boolean headless) {
        Checkup checkup = of(headless);
        if (PathEncoding.problem().isPresent()) {
            return checkup;
        }
        checkup.checks.add(StartTimeCheck::measured);
        if (!headless) {
            checkup.checks.add(GraphicsCheck::drawn);
        }
        checkup.checks.add(ProjectCheck::made);
        checkup.checks.add(ExerciseCheckup::graded);
        return checkup;
    }

    /** {@return the findings in the order of the checks; each check runs when its finding is requested} */
    public Iterable<Finding> findings() {
        return () -> checks.stream().map(Supplier::get).iterator();
    }
}
