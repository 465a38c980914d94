package org.robonewbie.competition.result;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import org.robonewbie.competition.contest.ContestTrial;
import org.robonewbie.competition.contest.Results;
import org.robonewbie.competition.contest.TrialResult;
import org.robonewbie.competition.team.TeamFolder;
import org.robonewbie.competition.team.WrongEntryException;
import org.robonewbie.competition.trial.TrialFiles;
import org.robonewbie.nao.file.AtomicFile;

/**
 * The folder in which a contest keeps everything: each finished trial in a file of its own, written atomically, so that an
 * interrupted contest continues where it was.
 */
public final class ResultFolder implements Results, AutoCloseable {

    private final Path folder;
    private final FileChannel lockFile;
    private final FileLock lock;
    private final Map<String, TrialResult> finished = new ConcurrentHashMap<>();

    private ResultFolder(Path folder, FileChannel lockFile, FileLock lock) {
        this.folder = folder;
        this.lockFile = lockFile;
        this.lock = lock;
    }

    /**
     * Opens a folder for one contest at a time.
     *
     * @param folder the folder; it is made if it does not exist
     * @return the open folder
     * @throws IOException if it cannot be written to
     * @throws WrongEntryException if another program is using it
     */
    public static ResultFolder open(Path folder) throws IOException {
        for (String part : new String[] {"trials", "recordings", "logs", "work", "certificates"}) {
            Files.createDirectories(folder.resolve(part));
        }
        FileChannel channel = FileChannel.open(
                folder.resolve(TeamFolder.RESULTS_LOCK), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        FileLock lock;
        try {
            lock = channel.tryLock();
        } catch (OverlappingFileLockException here) {
            lock = null;
        }
        if (lock == null) {
            channel.close();
            throw new WrongEntryException("Another competition is using the folder " + folder
                    + ". Wait for its end, or choose another folder with --results.");
        }
        return new ResultFolder(folder, channel, lock);
    }

    /**
     * Returns the path of a file of the results.
     *
     * @param name its name in this folder
     * @return the file
     */
    public Path file(String name) {
        return folder.resolve(name);
    }

    /**
     * Returns where a trial writes its files.
     *
     * @param trial the trial
     * @return its files
     */
    public TrialFiles filesOf(ContestTrial trial) {
        return new TrialFiles(Optional.of(recording(trial.id())), folder.resolve("logs"), folder.resolve("work"));
    }

    /**
     * Returns the recording of a trial.
     *
     * @param trialId name of the trial
     * @return the file, which {@code robonewbie studio} opens
     */
    public Path recording(String trialId) {
        return folder.resolve("recordings").resolve(trialId + ".rec");
    }

    /**
     * Looks whether a trial is over, under the same circumstances.
     *
     * @param trialId name of the trial
     * @param circumstances checksum of all that it depends on
     * @return whether its result is there now
     * @throws IOException if the folder cannot be read
     */
    public boolean load(String trialId, String circumstances) throws IOException {
        Path file = trialFile(trialId);
        if (!finished.containsKey(trialId) && Files.isRegularFile(file)) {
            TrialJson.read(Files.readString(file), circumstances).ifPresent(result -> finished.put(trialId, result));
        }
        return finished.containsKey(trialId);
    }

    /**
     * Keeps a result.
     *
     * @param result the result
     * @param circumstances checksum of all that it depends on
     * @throws IOException if it cannot be written
     */
    public void save(TrialResult result, String circumstances) throws IOException {
        AtomicFile.write(trialFile(result.id()), TrialJson.write(result, circumstances));
        finished.put(result.id(), result);
    }

    @Override
    public Optional<TrialResult> find(String trialId) {
        return Optional.ofNullable(finished.get(trialId));
    }

    @Override
    public void close() throws IOException {
        lock.release();
        lockFile.close();
    }

    private Path trialFile(String trialId) {
        return folder.resolve("trials").resolve(trialId + ".json");
    }
}
