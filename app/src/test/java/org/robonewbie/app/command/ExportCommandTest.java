package org.robonewbie.app.command;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Objects;
import java.util.Random;
import java.util.stream.Collectors;
import javax.xml.parsers.DocumentBuilderFactory;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.condition.DisabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.junit.jupiter.params.provider.ValueSource;
import org.robonewbie.app.Printed;
import org.robonewbie.app.ProcessResult;
import org.robonewbie.app.Python;
import org.robonewbie.nao.Joint;
import org.robonewbie.nao.Vector3;
import org.robonewbie.nao.kinematics.BodyPoses;
import org.robonewbie.nao.kinematics.ForwardKinematics;
import org.robonewbie.nao.kinematics.Pose;
import org.robonewbie.nao.model.Hinge;
import org.robonewbie.nao.model.Link;
import org.robonewbie.nao.model.MassDistribution;
import org.robonewbie.nao.model.NaoModel;
import org.robonewbie.nao.model.RobotType;
import org.robonewbie.nao.motion.Posture;
import org.w3c.dom.Document;

class ExportCommandTest {

    private static final int POSTURES = 1000;

    @TempDir
    Path folder = Path.of("");

    @ParameterizedTest
    @CsvSource({"speed, intvelocity", "position, position", "torque, motor"})
    void eachMotorHasItsNameInTheMessages(String kind, String element) throws Exception {
        Path file = folder.resolve("nao.xml");

        Printed printed = Printed.by("export", "--mjcf", file.toString(), "--motors", kind, "--scene", "pitch");

        assertThat(printed.exitCode()).isZero();
        assertThat(printed.out()).contains("nao.xml");
        Document document = read(file);
        assertThat(document.getElementsByTagName(element).getLength()).isEqualTo(22);
        assertThat(document.getElementsByTagName("touch")
                        .item(0)
                        .getAttributes()
                        .getNamedItem("name")
                        .getNodeValue())
                .isEqualTo("rf");
        assertThat(Files.readString(file)).contains("Apache-2.0", "\"lle4\"", "\"llj4\"", "\"ball\"");
    }

    private static Document read(Path file) throws Exception {
        return DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(file.toFile());
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "export",
                "export --urdf x --motors speed",
                "export --mjcf x --type 5",
                "export --mjcf x --scene moon"
            })
    void whatCannotBeWrittenIsRefused(String command) {
        Printed printed =
                Printed.by(command.replace(" x", " " + folder.resolve("x")).split(" "));

        assertThat(printed.exitCode()).isEqualTo(2);
        assertThat(printed.err()).containsAnyOf("--mjcf FILE", "0 to 4", "PLAIN");
        assertThat(folder).isEmptyDirectory();
    }

    @ParameterizedTest
    @EnumSource
    void packageForPythonHasTheFilesOfThisCommand(RobotType type) throws IOException {
        String name = "nao" + type.ordinal() + ".xml";
        Path file = folder.resolve(name);

        Printed.by("export", "--mjcf", file.toString(), "--type", String.valueOf(type.ordinal()));

        assertThat(withoutHead(file))
                .isEqualTo(
                        withoutHead(Python.PACKAGE.resolve("robonewbie/models").resolve(name)));
    }

    /** Leaves out the comment at the beginning, which contains the version. */
    private static String withoutHead(Path file) throws IOException {
        String text = Files.readString(file);
        return text.substring(text.indexOf("-->"));
    }

    @Tag("slow")
    @DisabledOnOs(value = OS.WINDOWS, disabledReason = "the launcher of this test is a shell script")
    @ParameterizedTest
    @CsvSource({"mjcf, 0", "mjcf, 1", "mjcf, 2", "mjcf, 3", "mjcf, 4", "urdf, 0", "urdf, 4"})
    void linksAreWhereTheSimulatorHasThem(String format, int number) throws Exception {
        Python python = new Python(folder);
        python.skipWithout("mujoco, numpy");
        RobotType type = RobotType.values()[number];
        Path file = folder.resolve("nao.xml");
        Printed.by("export", "--" + format, file.toString(), "--type", String.valueOf(number));
        List<Posture> postures = randomPostures();
        Path table = Files.write(folder.resolve("postures"), lines(type, postures));

        ProcessResult result = python.run(script().toString(), file.toString(), table.toString());

        assertThat(result.code()).as(result.printed()).isZero();
        List<String[]> read = Arrays.stream(result.printed().split("\\R"))
                .map(line -> line.split("\t"))
                .toList();
        hasTheJointsOf(type, read);
        hasTheLinksOf(type, read);
        hasThePosesOf(type, postures, read);
    }

    private static Path script() throws URISyntaxException {
        return Path.of(Objects.requireNonNull(ExportCommandTest.class.getResource("link-poses.py"))
                .toURI());
    }

    private static List<Posture> randomPostures() {
        Random random = new Random(1);
        List<Posture> postures = new ArrayList<>();
        for (int i = 0; i < POSTURES; i++) {
            postures.add(Posture.of(Arrays.stream(Joint.values())
                    .mapToDouble(joint ->
                            joint.minDegrees() + random.nextDouble() * (joint.maxDegrees() - joint.minDegrees()))
                    .toArray()));
        }
        return postures;
    }

    private static List<String> lines(RobotType type, List<Posture> postures) {
        List<Hinge> hinges = NaoModel.of(type).hinges();
        List<String> lines = new ArrayList<>();
        lines.add(hinges.stream().map(Hinge::perceptorName).collect(Collectors.joining("\t")));
        postures.forEach(posture -> lines.add(hinges.stream()
                .map(hinge -> Joint.ofEffector(hinge.effectorName())
                        .map(posture::degrees)
                        .orElse(0.0))
                .map(String::valueOf)
                .collect(Collectors.joining("\t"))));
        return lines;
    }

    private static void hasTheJointsOf(RobotType type, List<String[]> read) {
        List<String[]> joints =
                read.stream().filter(line -> line[0].equals("joint")).toList();
        List<Hinge> hinges = NaoModel.of(type).hinges();
        assertThat(joints).hasSameSizeAs(hinges);
        for (String[] joint : joints) {
            assertThat(hinges).anySatisfy(hinge -> {
                assertThat(joint[1]).isEqualTo(hinge.perceptorName());
                assertThat(numbers(joint))
                        .containsExactly(new double[] {hinge.minDegrees(), hinge.maxDegrees()}, within(1e-9));
            });
        }
    }

    private static void hasTheLinksOf(RobotType type, List<String[]> read) {
        List<String[]> links =
                read.stream().filter(line -> line[0].equals("link")).toList();
        assertThat(links).hasSameSizeAs(NaoModel.of(type).links());
        for (String[] line : links) {
            Link link = link(type, line[1]);
            Vector3 inertia = MassDistribution.of(link.shape(), link.massKg()).inertia();
            assertThat(numbers(line))
                    .containsExactly(
                            new double[] {link.massKg(), inertia.y(), inertia.x(), inertia.z()}, within(1e-10));
        }
    }

    private static void hasThePosesOf(RobotType type, List<Posture> postures, List<String[]> read) {
        List<BodyPoses> expected =
                postures.stream().map(ForwardKinematics.of(type)::poses).toList();
        int posture = -1;
        int poses = 0;
        for (String[] line : read) {
            if (line[0].equals("centre")) {
                posture++;
                Vector3 centre = expected.get(posture).centreOfMass();
                assertThat(numbers(line))
                        .containsExactly(new double[] {centre.x(), centre.y(), centre.z()}, within(1e-6));
            } else if (line[0].equals("pose")) {
                Pose pose = expected.get(posture).link(link(type, line[1]).name());
                assertThat(numbers(line)).as(line[1]).containsExactly(elements(pose), within(1e-6));
                poses++;
            }
        }
        assertThat(poses).isEqualTo(POSTURES * NaoModel.of(type).links().size());
    }

    private static Link link(RobotType type, String name) {
        NaoModel model = NaoModel.of(type);
        return model.links().get(model.linkIndex(name.equals("torso") ? NaoModel.TORSO : name));
    }

    /** Returns the position of a link and the nine elements of its rotation matrix by rows. */
    private static double[] elements(Pose pose) {
        Vector3 x = pose.rotation().apply(new Vector3(1, 0, 0));
        Vector3 y = pose.rotation().apply(new Vector3(0, 1, 0));
        Vector3 z = pose.rotation().apply(new Vector3(0, 0, 1));
        Vector3 at = pose.position();
        return new double[] {at.x(), at.y(), at.z(), x.x(), y.x(), z.x(), x.y(), y.y(), z.y(), x.z(), y.z(), z.z()};
    }

    private static double[] numbers(String... line) {
        return Arrays.stream(line).skip(2).mapToDouble(Double::parseDouble).toArray();
    }
}
