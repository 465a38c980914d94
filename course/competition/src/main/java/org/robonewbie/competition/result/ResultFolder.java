package org.robonewbie.competition.result;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.concurrent.ConcurrentHashMap;
import org.robonewbie.competition.contest.ContestTrial;
import org.robonewbie.competition.contest.Results;
import org.robonewbie.competition.contest.TrialResult;
import org.robonewbie.competition.trial.TrialFiles;
import org.robonewbie.nao.file.AtomicFile;
import org.robonewbie.nao.file.FolderLock;
import org.robonewbie.nao.file.RegularFile;
import org.robonewbie.nao.file.UnreadableFileException;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.programs.Fingerprint;

/**
 * Result folder of a contest. Each finished trial is a separate file that is written atomically, so an interrupted contest can
 * resume.
 */
public final class ResultFolder implements Results, AutoCloseable {

    /** Name of the file that is locked while a process is using the folder. */
    private static final String LOCK = "competition.lock";

    private final Path folder;
    private final FolderLock lock;
    private final Map<String, TrialJson.Kept> finished = new ConcurrentHashMap<>();
    private final Map<String, String> written = new ConcurrentHashMap<>();

    private ResultFolder(Path folder, FolderLock lock) {
        this.folder = folder;
        this.lock = lock;
    }

    /**
     * Opens and locks a folder.
     *
     * @param folder the folder; created if it does not exist
     * @return the open folder
     * @throws IOException if it is not writable
     * @throws CalledWronglyException if another process is using it
     */
    public static ResultFolder open(Path folder) throws IOException {
        for (String part : new String[] {"trials", "recordings", "logs", "work", "certificates"}) {
            Files.createDirectories(folder.resolve(part));
        }
        FolderLock lock = FolderLock.take(folder.resolve(LOCK))
                .orElseThrow(() -> new CalledWronglyException("Another competition is using the folder " + folder
                        + ". Wait until it ends, or choose another folder with --results."));
        return new ResultFolder(folder, lock);
    }

    /**
     * Returns a file in the folder.
     *
     * @param name name of the file
     * @return the file
     */
    public Path file(String name) {
        return folder.resolve(name);
    }

    /**
     * Returns the paths of a trial's output files.
     *
     * @param trial the trial
     * @return the paths
     */
    public TrialFiles filesOf(ContestTrial trial) {
        return new TrialFiles(Optional.of(recording(trial.id())), folder.resolve("logs"), folder.resolve("work"));
    }

    /**
     * Returns the path of a trial's recording.
     *
     * @param trialId name of the trial
     * @return the file, which can be opened with {@code robonewbie studio}
     */
    public Path recording(String trialId) {
        return folder.resolve("recordings").resolve(trialId + ".rec");
    }

    /**
     * Loads the result of a trial, unless something on which it depends has changed since it was saved.
     *
     * @param trialId name of the trial
     * @param circumstances checksum of everything that the result depends on
     * @return whether the result is available
     * @throws IOException if the folder cannot be read
     */
    public boolean load(String trialId, String circumstances) throws IOException {
        Path file = trialFile(trialId);
        if (!finished.containsKey(trialId) && Files.isRegularFile(file)) {
            String text = Files.readString(file);
            TrialJson.read(text, circumstances).ifPresent(kept -> {
                finished.put(trialId, kept);
                written.put(trialId, text);
            });
        }
        return finished.containsKey(trialId);
    }

    /**
     * Saves a result.
     *
     * @param result the result
     * @param circumstances checksum of everything that the result depends on
     * @throws IOException if the file cannot be written
     */
    public void save(TrialResult result, String circumstances) throws IOException {
        Path recording = recording(result.id());
        TrialJson.Kept kept =
                new TrialJson.Kept(result, Files.isRegularFile(recording) ? Fingerprint.sha256(recording) : "");
        String text = TrialJson.write(kept, circumstances);
        AtomicFile.write(trialFile(result.id()), text);
        finished.put(result.id(), kept);
        written.put(result.id(), text);
    }

    /**
     * Returns the checksum of a recording as it was at the end of the trial.
     *
     * @param trialId name of the trial
     * @return the SHA-256; empty if the trial was not recorded
     */
    public Optional<String> recordingSha256(String trialId) {
        return Optional.ofNullable(finished.get(trialId))
                .map(TrialJson.Kept::recordingSha256)
                .filter(sum -> !sum.isEmpty());
    }

    /**
     * Detects files that were modified by other programs during the contest, and restores the results.
     *
     * @return one sentence per modified file
     * @throws IOException if a file cannot be read or written
     */
    public List<String> repair() throws IOException {
        List<String> sentences = new ArrayList<>();
        for (Map.Entry<String, String> trial : new TreeMap<>(written).entrySet()) {
            Path file = trialFile(trial.getKey());
            if (!holds(file, trial.getValue().getBytes(StandardCharsets.UTF_8))) {
                AtomicFile.write(file, trial.getValue());
                sentences.add("The file " + file + " was modified during the contest and has been restored.");
            }
            Path recording = recording(trial.getKey());
            Optional<String> sum = recordingSha256(trial.getKey());
            if (sum.isPresent()
                    && Files.isRegularFile(recording)
                    && !Fingerprint.sha256(recording).equals(sum.get())) {
                sentences.add("The recording " + recording
                        + " was modified after its trial; the checksum in the table is the original one.");
            }
        }
        return sentences;
    }

    /**
     * Returns whether a file has the given contents. Safe even if a program has replaced the file with a huge one or a
     * pipe.
     */
    private static boolean holds(Path file, byte[] content) {
        try {
            return Arrays.equals(RegularFile.read(file, content.length), content);
        } catch (UnreadableFileException another) {
            return false;
        }
    }

    @Override
    public Optional<TrialResult> find(String trialId) {
        return Optional.ofNullable(finished.get(trialId)).map(TrialJson.Kept::result);
    }

    @Override
    public void close() throws IOException {
        lock.close();
    }

    private Path trialFile(String trialId) {
        return folder.resolve("trials").resolve(trialId + ".json");
    }
}
