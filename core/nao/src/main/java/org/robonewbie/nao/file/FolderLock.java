package org.robonewbie.nao.file;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;

/** The right to write into a folder, which one program has at a time; the system gives it back if the program is killed. */
public final class FolderLock implements AutoCloseable {

    private final FileChannel channel;

    private FolderLock(FileChannel channel) {
        this.channel = channel;
    }

    /**
     * Takes the lock.
     *
     * @param file the file that stands for the folder; it is made and stays
     * @return the lock; empty if another program holds it
     * @throws IOException if the file cannot be written
     */
    public static Optional<FolderLock> take(Path file) throws IOException {
        FileChannel channel = open(file);
        if (isTaken(channel)) {
            channel.close();
            return Optional.empty();
        }
        return Optional.of(new FolderLock(channel));
    }

    private static FileChannel open(Path file) throws UnwritableFileException {
        try {
            return FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        } catch (IOException unwritable) {
            throw UnwritableFileException.of(file, unwritable);
        }
    }

    /** Locks a place behind all contents, so that others can read the file where locks keep readers out. */
    static boolean isTaken(FileChannel channel) throws IOException {
        try {
            FileLock lock = channel.tryLock(Long.MAX_VALUE - 1, 1, false);
            return lock == null;
        } catch (OverlappingFileLockException here) {
            return true;
        }
    }

    @Override
    public void close() throws IOException {
        channel.close();
    }
}
