package org.robonewbie.app.doctor;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.robonewbie.nao.math.MathFingerprint;
import org.robonewbie.programs.CompilerOfThisJava;

/** Looks at the Java that runs this program. */
final class JavaCheck {

    private static final int OLDEST = 17;
    private static final double GIGABYTE = 1L << 30;
    private static final double LEAST_GIGABYTES = 0.25;

    private JavaCheck() {}

    static Finding version() {
        String found = System.getProperty("java.version") + " of " + System.getProperty("java.vendor") + ", "
                + System.getProperty("os.name") + " " + System.getProperty("os.arch");
        return Runtime.version().feature() < OLDEST
                ? Finding.broken("Java", found, "Install a JDK " + OLDEST + " or newer, for example from adoptium.net.")
                : Finding.well("Java", found);
    }

    static Finding compiler() {
        return CompilerOfThisJava.isThere()
                ? Finding.well("Compiler", "agents can be run from their .java files")
                : Finding.notable(
                        "Compiler",
                        "none in " + System.getProperty("java.home"),
                        "To run .java files install a JDK instead of a Java run-time (JRE).");
    }

    static Finding mathematics() {
        return mathematics(MathFingerprint.all());
    }

    static Finding mathematics(List<MathFingerprint> fingerprints) {
        String different = fingerprints.stream()
                .filter(fingerprint -> !fingerprint.isAsEverywhere())
                .map(MathFingerprint::function)
                .collect(Collectors.joining(", "));
        return different.isEmpty()
                ? Finding.well(
                        "Mathematics", fingerprints.size() + " functions give the same bits as on every computer")
                : Finding.broken(
                        "Mathematics",
                        different + ": other results than on other computers",
                        "Use another JDK: with this one the same seed gives another run.");
    }

    static Finding memory() {
        return memory(
                Runtime.getRuntime().maxMemory() / GIGABYTE,
                Runtime.getRuntime().availableProcessors());
    }

    static Finding memory(double gigabytes, int processors) {
        String found = String.format(
                Locale.ROOT, "Java may use %.1f GB; %d processor%s", gigabytes, processors, processors == 1 ? "" : "s");
        return gigabytes < LEAST_GIGABYTES
                ? Finding.notable("Memory", found, "Close other programs; RoboNewbie wants " + LEAST_GIGABYTES + " GB.")
                : Finding.well("Memory", found);
    }
}
