package org.robonewbie.competition.programs;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.PosixFilePermissions;
import java.util.List;

/** Fills each file system that it sees, since a file there may be memory that no limit counts. */
public final class FillsMemory {

    private static final int MAX_MEGABYTES = 400;

    private FillsMemory() {}

    /**
     * Prints how many megabytes it could write in each folder, and in all of them together, then brings the robot.
     *
     * @param args options of the robot; the folders stand in the file {@code folders} beside it
     */
    public static void main(String[] args) throws IOException {
        List<String> folders = Files.readAllLines(Path.of("folders"));
        int all = 0;
        for (String folder : folders) {
            int megabytes = fill(Path.of(folder));
            System.out.println(folder + " took " + megabytes + " MB");
            all += megabytes;
        }
        System.out.println("all took " + all + " MB");
        folders.forEach(folder -> fileIn(Path.of(folder)).toFile().delete());
        Stands.main(args);
    }

    private static Path fileIn(Path folder) {
        return folder.resolve("robonewbie-fill");
    }

    private static int fill(Path folder) {
        byte[] megabyte = new byte[1 << 20];
        int written = 0;
        try {
            Files.setPosixFilePermissions(folder, PosixFilePermissions.fromString("rwxrwxrwx"));
        } catch (IOException notMine) {
            System.out.println(folder + " stays as it is");
        }
        try (OutputStream file = Files.newOutputStream(fileIn(folder))) {
            for (; written < MAX_MEGABYTES; written++) {
                file.write(megabyte);
            }
        } catch (IOException full) {
            System.out.println(folder + " takes no more");
        }
        return written;
    }
}
