package org.robonewbie.app.studio;

import java.io.File;
import java.io.IOException;
import java.net.URLDecoder;
import java.net.URLEncoder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import org.robonewbie.nao.file.TemporaryFiles;
import org.robonewbie.programs.CalledWronglyException;
import org.robonewbie.simulator.file.RecordingFile;
import org.robonewbie.simulator.file.RecordingRepository;
import org.robonewbie.simulator.recording.RecordingReader;
import org.robonewbie.studio.StudioFolders;
import org.robonewbie.studio.monitor.LogConversion;

/**
 * The file that the studio opens at start.
 *
 * @param folders the folders that the pages may access, including the file
 * @param place fragment of the page's URL that shows the file
 * @param programs folder of the user's programs
 */
public record OpenedFile(StudioFolders folders, String place, Path programs) {

    private static final String MOTION = ".txt";
    private static final String PROGRAM = ".java";
    private static final long MAX_WAIT_SECONDS = 5;
    private static final String PLAYING = "@play";
    private static final String PROGRAM_PLACE = "#program/";

    private OpenedFile(StudioFolders folders, String place) {
        this(folders, place, Path.of("").toAbsolutePath());
    }

    /**
     * Opens a file: a recording, a log of a server, a motion or a program.
     *
     * @param file the file, if one was given
     * @return what the studio shows
     * @throws IOException if a log cannot be converted
     * @throws CalledWronglyException if the file does not exist or has an unsupported type
     */
    public static OpenedFile of(Optional<Path> file) throws IOException {
        return file.isPresent()
                ? of(file.get().toAbsolutePath())
                : new OpenedFile(StudioFolders.ofWorkingDirectory(), "");
    }

    private static OpenedFile of(Path file) throws IOException {
        if (!Files.isRegularFile(file)) {
            throw new CalledWronglyException("There is no file \"" + file + "\". Check the name.");
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

    /** Returns the URL fragment that opens a motion from the studio's folder in the motion editor. */
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

    /** Opens a program of this project, or one in another folder together with the other files in that folder. */
    private static OpenedFile program(Path file) {
        Path here = Path.of("").toAbsolutePath();
        Path folder = file.startsWith(here)
                ? here
                : Optional.ofNullable(file.getParent()).orElse(here);
        String path = folder.relativize(file).toString().replace(File.separatorChar, '/');
        return new OpenedFile(StudioFolders.ofWorkingDirectory(), PROGRAM_PLACE + encoded(path), folder);
    }

    /** {@return the path of the program relative to {@link #programs}, separated by slashes; empty for other files} */
    Optional<String> program() {
        return Optional.of(place)
                .filter(each -> each.startsWith(PROGRAM_PLACE))
                .map(each -> URLDecoder.decode(each.substring(PROGRAM_PLACE.length()), StandardCharsets.UTF_8));
    }

    private static boolean isRecording(Path file) {
        try (RecordingReader reader = RecordingFile.read(file)) {
            return !reader.header().isEmpty();
        } catch (IOException isNone) {
            return false;
        }
    }

    /** Converts a log to a temporary recording, which is deleted when the program exits. */
    private static Path converted(Path log, String name) throws IOException {
        Path folder = TemporaryFiles.folder("robonewbie-log");
        Path recording = folder.resolve(name.replaceAll("\\.(log|txt|gz)", "") + RecordingRepository.ENDING);
        recording.toFile().deleteOnExit();
        folder.toFile().deleteOnExit();
        try {
            LogConversion conversion = LogConversion.start(log, recording);
            if (!conversion.awaitEnd(MAX_WAIT_SECONDS)) {
                System.out.println("The log is long; the studio shows what has been read so far.");
            }
            conversion.reportTo(System.out::println);
        } catch (IOException unreadable) {
            throw new CalledWronglyException("The studio cannot open this file: " + unreadable.getMessage()
                    + " It opens recordings (.rec), logs of SimSpark servers and of RCSSServerMJ, motions (.txt) and"
                    + " programs (.java).");
        }
        return recording;
    }

    private static String encoded(String text) {
        return URLEncoder.encode(text, StandardCharsets.UTF_8).replace("+", "%20");
    }
}
