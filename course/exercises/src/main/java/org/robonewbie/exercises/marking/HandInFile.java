package org.robonewbie.exercises.marking;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.URLDecoder;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Base64;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.zip.GZIPInputStream;
import org.robonewbie.nao.file.RegularFile;
import org.robonewbie.nao.file.TextFile;
import org.robonewbie.nao.file.UnreadableFileException;

/** Reads files with a {@link HandIn}, and text files with links that contain one. */
final class HandInFile {

    private static final String ENDING = ".robonewbie";
    private static final String LINKS = ".txt";

    private static final Pattern LINK = Pattern.compile("submission=([\\w%=-]*)");

    private HandInFile() {}

    /** Reads a file and reports anything that cannot be read; returns whether the file contains a submission, even a damaged one. */
    static boolean read(Path file, ReceivedWork target) {
        String name = String.valueOf(file.getFileName());
        try {
            if (name.endsWith(ENDING)) {
                add(name, RegularFile.read(file, HandIn.MAX_BYTES), target);
                return true;
            }
            return name.endsWith(LINKS) && readLinks(name, TextFile.read(file).lines(), target);
        } catch (UnreadableFileException unreadable) {
            target.refuse(name, String.valueOf(unreadable.getMessage()));
            return true;
        }
    }

    private static boolean readLinks(String name, List<String> lines, ReceivedWork target) {
        boolean found = false;
        for (int i = 0; i < lines.size(); i++) {
            String source = name + ", line " + (i + 1);
            for (Matcher link = LINK.matcher(lines.get(i)); link.find(); found = true) {
                try {
                    add(
                            source,
                            Base64.getUrlDecoder().decode(URLDecoder.decode(link.group(1), StandardCharsets.UTF_8)),
                            target);
                } catch (IllegalArgumentException damaged) {
                    target.refuse(source, HandIn.DAMAGED);
                }
            }
        }
        return found;
    }

    private static void add(String source, byte[] packed, ReceivedWork target) {
        try (GZIPInputStream in = new GZIPInputStream(new ByteArrayInputStream(packed))) {
            byte[] bytes = in.readNBytes(HandIn.MAX_BYTES + 1);
            if (bytes.length > HandIn.MAX_BYTES) {
                target.refuse(source, "It is larger than " + HandIn.MAX_BYTES / 1_000_000 + " MB unpacked.");
            } else {
                target.add(
                        source,
                        StandardCharsets.UTF_8
                                .newDecoder()
                                .decode(ByteBuffer.wrap(bytes))
                                .toString());
            }
        } catch (IOException damaged) {
            target.refuse(source, HandIn.DAMAGED);
        }
    }
}
