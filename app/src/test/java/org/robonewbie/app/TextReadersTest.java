package org.robonewbie.app;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;

/**
 * Text that people wrote is read by {@link org.robonewbie.nao.file.TextFile} only, which knows the encodings of their editors. What
 * decodes text by itself is listed here with the reason why people do not write it.
 */
class TextReadersTest {

    private static final Pattern OWN_DECODING =
            Pattern.compile("Files\\s*\\.(readString|readAllLines|lines|newBufferedReader)\\s*\\("
                    + "|new (FileReader|Scanner|InputStreamReader)\\s*\\("
                    + "|new String\\s*\\([^;]*?(readAllBytes|readNBytes|Charset|charset)"
                    + "|Channels\\s*\\.newReader\\s*\\(|\\.newDecoder\\(|\\bcharset\\w*\\.decode\\(|_8\\s*\\.decode\\("
                    + "|[pP]roperties\\s*\\.load\\s*\\("
                    + "|Files\\s*::\\s*(readString|readAllLines|lines|newBufferedReader)");

    private static final String READER = "the reader itself";
    private static final String RESOURCE = "comes with this program";
    private static final String WRITTEN = "only this program writes it";
    private static final String WIRE = "comes from a socket or pipe, in the encoding of the protocol";
    private static final String SYSTEM = "the operating system writes it";
    private static final String BUILD = "a source of this project, read while it is built";

    private static final Map<String, String> EXCEPTIONS = Map.ofEntries(
            Map.entry("nao/text/DecodedText", READER),
            Map.entry(
                    "nao/motion/MotionFile", "decodes the bytes of a motion, which the room Motion keeps as they are"),
            Map.entry("nao/motion/file/ShippedMotions", RESOURCE),
            Map.entry("nao/state/StateReader", WRITTEN),
            Map.entry("protocol/tcp/TelemetryClient", WIRE),
            Map.entry("protocol/tcp/TelemetryConnection", WIRE),
            Map.entry("protocol/frame/MessageBuffer", WIRE),
            Map.entry("protocol/sexp/SexpReader", WIRE),
            Map.entry("protocol/perceptor/LeagueMessageReader", WIRE),
            Map.entry("protocol/sexp/DecimalParser", WIRE),
            Map.entry("agent/policy/file/PolicyFile", RESOURCE),
            Map.entry("simulator/file/RecordingAbout", WRITTEN),
            Map.entry("exercises/marking/HandInFile", WRITTEN),
            Map.entry("web/PageScenes", WRITTEN),
            Map.entry("simulator/recording/RecordingReader", WRITTEN),
            Map.entry("simulator/recording/RecordingState", WRITTEN),
            Map.entry("simulator/recording/RecordCursor", WRITTEN),
            Map.entry("workshop/fidelity/FidelityBench", RESOURCE),
            Map.entry("workshop/jmh/ReplayLink", WIRE),
            Map.entry("workshop/sparring/FrozenTeam", "error messages of Git"),
            Map.entry("workshop/fidelity/ReferenceReader", "recordings of a server, written by a program"),
            Map.entry("trial/batch/Journal", WRITTEN),
            Map.entry("learning/policy/PolicySearch", WRITTEN),
            Map.entry("learning/dataset/DataSet", WRITTEN),
            Map.entry("learning/environment/EnvironmentConnection", WIRE),
            Map.entry("programs/process/Sandbox", SYSTEM),
            Map.entry("programs/process/LinuxProcess", SYSTEM),
            Map.entry("competition/result/ResultFolder", WRITTEN),
            Map.entry("exercises/progress/Worksheet", RESOURCE),
            Map.entry("exercises/progress/ProgressFile", WRITTEN),
            Map.entry("exercises/Translations", RESOURCE),
            Map.entry("exercises/Exercise", RESOURCE),
            Map.entry("studio/AccessToken", WRITTEN),
            Map.entry("studio/WebFiles", RESOURCE),
            Map.entry("studio/WebFile", RESOURCE),
            Map.entry("studio/motion/MotionApi", WIRE),
            Map.entry("studio/program/ProgramApi", WIRE),
            Map.entry("studio/league/LeagueServer", "the output of a process, in the encoding of the system"),
            Map.entry("studio/replay/RecordingIndex", WRITTEN),
            Map.entry("studio/roboviz/RoboVizReader", WIRE),
            Map.entry("site/SiteBuilder", RESOURCE),
            Map.entry("site/SourcePages", BUILD),
            Map.entry("site/ApiPages", BUILD),
            Map.entry("site/Article", BUILD),
            Map.entry("site/Commit", BUILD),
            Map.entry("app/command/ProgramVersion", RESOURCE),
            Map.entry("app/StartArchive", WRITTEN),
            Map.entry("exercises/marking/KeptMarks", WRITTEN),
            Map.entry("app/doctor/GraphicsCheck", SYSTEM),
            Map.entry("app/doctor/PortCheck", WIRE),
            Map.entry("app/doctor/ProjectCheck", "the output of Maven, in the encoding of the system"),
            Map.entry("programs/ApiComments", RESOURCE),
            Map.entry("programs/ExampleSources", RESOURCE),
            Map.entry("programs/process/ParentProcess", WIRE),
            Map.entry("programs/process/ProgramOutput", "the output of a process, in the encoding of the system"),
            Map.entry("programs/project/ExampleTeam", RESOURCE),
            Map.entry("programs/project/NewProject", RESOURCE),
            Map.entry("exercises/marking/JudgesKey", WRITTEN));

    @Test
    void textOfPeopleIsReadByOneReader() {
        assertThat(found())
                .as("Read text of people with TextFile, or say in EXCEPTIONS why people do not write it.")
                .isSubsetOf(EXCEPTIONS.keySet());
    }

    @Test
    void noExceptionIsListedWithoutNeed() {
        assertThat(EXCEPTIONS.keySet())
                .as("These classes do not decode text by themselves any more. Take them out of EXCEPTIONS.")
                .isSubsetOf(found());
    }

    @Test
    void ownDecodingIsFoundInEachForm() {
        assertThat(List.of(
                        "Files.readString(file)",
                        "Files.readAllLines(file, UTF_8)",
                        "Files\n    .lines(file)",
                        "new InputStreamReader(in)",
                        "new String(in.readAllBytes(), UTF_8)",
                        "new String(bytes, StandardCharsets.UTF_8)",
                        "properties.load(in)",
                        "map(Files::readString)"))
                .allMatch(code -> OWN_DECODING.matcher(code).find());
        assertThat(List.of("TextFile.read(file)", "new String(letters)", "Files.readAllBytes(file)", "image.load(in)"))
                .noneMatch(code -> OWN_DECODING.matcher(code).find());
    }

    private static Set<String> found() {
        Set<String> found = new TreeSet<>();
        for (Path file : Project.productSources(".java")) {
            String code = Project.read(file).replaceAll("(?s)/\\*.*?\\*/|//[^\\n]*", "");
            if (OWN_DECODING.matcher(code).find()) {
                String path = Project.ROOT.relativize(file).toString().replace('\\', '/');
                found.add(path.replaceFirst(".*/org/robonewbie/", "").replace(".java", ""));
            }
        }
        return found;
    }
}
