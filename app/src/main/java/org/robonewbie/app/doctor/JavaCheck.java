package org.robonewbie.app.doctor;

import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.robonewbie.nao.math.MathFingerprint;
import org.robonewbie.programs.CompilerOfThisJava;

/** Checks the Java runtime of this program. */
final class JavaCheck {

    private static final int MIN_JAVA = 17;
    private static final double GIGABYTE = 1L << 30;
    private static final double MIN_GIGABYTES = 0.25;

    private JavaCheck() {}

    static Finding version() {
        String found = System.getProperty("java.version") + " of " + System.getProperty("java.vendor") + ", "
                + System.getProperty("os.name") + " " + System.getProperty("os.arch");
        return Runtime.version().feature() < MIN_JAVA
                ? Finding.broken(
                        "Java", found, "Install a JDK " + MIN_JAVA + " or newer, for example from adoptium.net.")
                : Finding.well("Java", found);
    }

    static Finding compiler() {
        return CompilerOfThisJava.isThere()
                ? Finding.well("Compiler", "agents can be run from .java files")
                : Finding.notable(
                        "Compiler",
                        "not found in " + System.getProperty("java.home"),
                        "To run .java files, install a JDK instead of a Java runtime (JRE).");
    }

    static Finding mathematics() {
        return mathematics(MathFingerprint.all());
    }

    static Finding mathematics(List<MathFingerprint> fingerprints) {
        String different = fingerprints.stream()
                .filter(fingerprint -> !fingerprint.matches())
                .map(MathFingerprint::function)
                .collect(Collectors.joining(", "));
        return different.isEmpty()
                ? Finding.well(
                        "Mathematics", fingerprints.size() + " functions give the same results on every computer")
                : Finding.broken(
                        "Mathematics",
                        different + ": results differ from other computers",
                        "Use another JDK: with this one, the same seed gives a different run.");
    }

    static Finding memory() {
        return memory(
                Runtime.getRuntime().maxMemory() / GIGABYTE,
                Runtime.getRuntime().availableProcessors());
    }

    static Finding memory(double gigabytes, int processors) {
        String found = String.format(
                Locale.ROOT, "Java can use %.1f GB; %d processor%s", gigabytes, processors, processors == 1 ? "" : "s");
        return gigabytes < MIN_GIGABYTES
                ? Finding.notable("Memory", found, "Close other programs; RoboNewbie needs " + MIN_GIGABYTES + " GB.")
                : Finding.well("Memory", found);
    }
}
