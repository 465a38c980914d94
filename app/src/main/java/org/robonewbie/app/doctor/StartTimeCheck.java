package org.robonewbie.app.doctor;

import java.io.IOException;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.TimeUnit;
import org.robonewbie.programs.process.JavaCommand;

/** Measures the start time of this program, which reveals slow virus scanners and network drives. */
final class StartTimeCheck {

    private static final String SUBJECT = "Start time";
    private static final int STARTS = 2;
    private static final double SLOW_SECONDS = 4;
    private static final int MAX_SECONDS = 60;
    private static final double NANOSECONDS_PER_SECOND = 1e9;

    private StartTimeCheck() {}

    static Finding measured() {
        try {
            double best = Double.POSITIVE_INFINITY;
            for (int start = 0; start < STARTS; start++) {
                best = Math.min(best, seconds());
            }
            return of(best);
        } catch (IOException failed) {
            return Finding.broken(
                    SUBJECT, String.valueOf(failed.getMessage()), "Is this account allowed to start programs?");
        } catch (InterruptedException stopped) {
            Thread.currentThread().interrupt();
            return Finding.notable(SUBJECT, "not measured", "The check was interrupted.");
        }
    }

    static Finding of(double seconds) {
        String found = String.format(Locale.ROOT, "%.1f s, the best of %d", seconds, STARTS);
        return seconds <= SLOW_SECONDS
                ? Finding.well(SUBJECT, found)
                : Finding.notable(
                        SUBJECT,
                        found,
                        "Exclude the program's folder from virus scanning, or copy the folder from the network drive to a local disk.");
    }

    private static double seconds() throws IOException, InterruptedException {
        long begin = System.nanoTime();
        Process process = new ProcessBuilder(JavaCommand.ofCommand(List.of("--version")))
                .redirectErrorStream(true)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .start();
        boolean ended = process.waitFor(MAX_SECONDS, TimeUnit.SECONDS);
        process.destroyForcibly();
        return ended ? (System.nanoTime() - begin) / NANOSECONDS_PER_SECOND : Double.POSITIVE_INFINITY;
    }
}
