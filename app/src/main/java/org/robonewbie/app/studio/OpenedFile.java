package org.robonewbie.app.studio;

import java.io.File;
import java.io.IOException;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import org.robonewbie.app.program.CalledWronglyException;
import org.robonewbie.nao.file.TemporaryFiles;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.simulator.file.RecordingRepository;
import org.robonewbie.simulator.recording.RecordingReader;
import org.robonewbie.studio.StudioFolders;
import org.robonewbie.studio.monitor.MonitorLogReader;

/**
 * A file with which the studio opens.
 *
 * @param folders what the pages may use, with the file
 * @param place the room that shows the file, as the end of the page's address
 * @param programs the folder of the person's programs
 */
public record OpenedFile(StudioFolders folders, String place, Path programs) {

    private static final String MOTION = ".txt";
    private static final String PROGRAM = ".java";
    private static final String PLAYING = "@play";

    private OpenedFile(StudioFolders folders, String place) {
        this(folders, place, Path.of("").toAbsolutePath());
    }

    /**
     * Opens a file: a recording, a log of a SimSpark server, a motion or a program.
     *
     * @param file the file, if one was named
     * @return what the studio is to show
     * @throws IOException if a log cannot be converted
     * @throws CalledWronglyException if there is no such file or the studio cannot show it
     */
    public static OpenedFile of(Optional<Path> file) throws IOException {
        return file.isPresent()
                ? of(file.get().toAbsolutePath())
                : new OpenedFile(StudioFolders.ofWorkingDirectory(), "");
    }

    private static OpenedFile of(Path file) throws IOException {
        if (!Files.isRegularFile(file)) {
            throw new CalledWronglyException("There is no file \"" + file + "\". Is its name right?");
        }
        String name = String.valueOf(file.getFileName());
        if (name.toLowerCase(Locale.ROOT).endsWith(MOTION)) {
            return motion(file);
        }
        if (name.endsWith(PROGRAM)) {
            return program(file);
        }
        Path recording = isRecording(file) ? file : converted(file, name);
        String title = String.valueOf(recording.getFileName()).replace(".part", "");
        String shown = title.replace(RecordingRepository.ENDING, "");
        return new OpenedFile(
                StudioFolders.ofWorkingDirectory().withRecording(recording), "#replay/" + encoded(shown) + PLAYING);
    }

    /** The room that shows a motion of the studio's folder. */
    static String motionPlace(Path file) {
        String name = String.valueOf(file.getFileName());
        return "#motion/" + encoded(name.substring(0, name.length() - MOTION.length()));
    }

    private static OpenedFile motion(Path file) {
        Path folder = Optional.ofNullable(file.getParent()).orElse(file);
        StudioFolders folders = StudioFolders.ofWorkingDirectory();
        return new OpenedFile(
                new StudioFolders(folder, folders.scenes(), folders.recordings(), folders.projects(), Optional.empty()),
                motionPlace(file));
    }

    /** A program of this project, or one that lies elsewhere, with what is beside it. */
    private static OpenedFile program(Path file) {
        Path here = Path.of("").toAbsolutePath();
        Path folder = file.startsWith(here)
                ? here
                : Optional.ofNullable(file.getParent()).orElse(here);
        String path = folder.relativize(file).toString().replace(File.separatorChar, '/');
        return new OpenedFile(StudioFolders.ofWorkingDirectory(), "#program/" + encoded(path), folder);
    }

    private static boolean isRecording(Path file) {
        try (RecordingReader reader = RecordingFile.read(file)) {
            return !reader.header().isEmpty();
        } catch (IOException isNone) {
            return false;
        }
    }

    /** A log is turned into a recording, which the system's folder for temporary files keeps until the program ends. */
    private static Path converted(Path log, String name) throws IOException {
        Path folder = TemporaryFiles.folder("robonewbie-log");
        Path recording = folder.resolve(name.replaceAll("\\.(log|txt|gz)", "") + RecordingRepository.ENDING);
        recording.toFile().deleteOnExit();
        folder.toFile().deleteOnExit();
        try {
            MonitorLogReader.convert(log, recording);
        } catch (IOException unreadable) {
            throw new CalledWronglyException("The studio cannot open it: " + unreadable.getMessage()
                    + " It opens recordings (.rec), logs of SimSpark servers, motions (.txt) and programs (.java).");
        }
        return recording;
    }

    private static String encoded(String text) {
        return URLEncoder.encode(text, StandardCharsets.UTF_8).replace("+", "%20");
    }
}
