package org.robonewbie.nao.file;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;

/** A program's exclusive lock on a folder. The operating system releases it if the program is killed. */
public final class FolderLock implements AutoCloseable {

    private final FileChannel channel;

    private FolderLock(FileChannel channel) {
        this.channel = channel;
    }

    /**
     * Tries to acquire the lock.
     *
     * @param file the lock file; it is created if necessary, and never deleted
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

    /**
     * Tries to lock the file; returns whether another program holds the lock. Only one byte far beyond the contents is
     * locked, because a mandatory lock on the contents, as on Windows, would prevent other programs from reading them.
     */
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
