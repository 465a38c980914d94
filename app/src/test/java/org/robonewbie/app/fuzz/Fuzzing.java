package org.robonewbie.app.fuzz;

/** What Jazzer calls, see {@code .ci/fuzz}. */
public final class Fuzzing {

    private static FuzzedReader reader = FuzzedReader.PERCEPTORS;

    private Fuzzing() {}

    /**
     * Chooses the reader.
     *
     * @param arguments its name
     */
    public static void fuzzerInitialize(String[] arguments) {
        reader = FuzzedReader.named(arguments[0]);
    }

    /**
     * Tries one input.
     *
     * @param bytes what Jazzer has made up
     */
    public static void fuzzerTestOneInput(byte[] bytes) {
        reader.read(bytes);
    }
}
