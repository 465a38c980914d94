package org.robonewbie.app;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** A file system of a few kilobytes in memory, which is soon full. Only the administrator of a Linux system may make one; others skip the test. */
final class SmallDisk implements AutoCloseable {

    private final Path place;

    private SmallDisk(Path place) {
        this.place = place;
    }

    /** Mounts it in an empty folder. */
    static SmallDisk at(Path place, int kilobytes) throws IOException, InterruptedException {
        String said = said("mount", "-t", "tmpfs", "-o", "size=" + kilobytes + "k", "tmpfs", place.toString());
        assumeTrue(said.isEmpty(), "no small disk can be made here: " + said);
        return new SmallDisk(place);
    }

    /** Takes all room that is left. */
    void fill() throws IOException {
        try (OutputStream filler = Files.newOutputStream(place.resolve("filler"))) {
            byte[] page = new byte[4096];
            while (true) {
                filler.write(page);
            }
        } catch (IOException full) {
            if (!String.valueOf(full.getMessage()).contains("No space left")) {
                throw full;
            }
        }
    }

    /** Gives it more room than is needed. */
    void makeRoom() throws IOException, InterruptedException {
        String said = said("mount", "-o", "remount,size=100m", place.toString());
        if (!said.isEmpty()) {
            throw new IOException(said);
        }
    }

    @Override
    public void close() throws IOException {
        try {
            said("umount", "--lazy", place.toString());
        } catch (InterruptedException end) {
            Thread.currentThread().interrupt();
        }
    }

    private static String said(String... command) throws IOException, InterruptedException {
        try {
            Process process = new ProcessBuilder(List.of(command))
                    .redirectErrorStream(true)
                    .start();
            String said = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
            return process.waitFor() == 0 ? "" : said.strip() + " ";
        } catch (IOException noSuchCommand) {
            return String.valueOf(noSuchCommand.getMessage());
        }
    }
}
