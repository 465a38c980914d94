package org.robonewbie.protocol.monitor;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.monitor.LightNode.Colour;
import org.robonewbie.protocol.monitor.MeshNode.MeshFile;
import org.robonewbie.protocol.monitor.MeshNode.StandardShape;

class SceneRoundTripTest {

    private final Environment environment = new Environment(List.of(), List.of());

    @Property(tries = 300)
    void readerKnowsEachSceneThatTheWriterTells(@ForAll long seed) {
        List<SceneNode> scene = randomNodes(new Random(seed), 3);
        MonitoredWorld world = new MonitoredWorld();

        MessageBuffer message =
                new MonitorMessageWriter(environment).writeFull(MonitoredGame.UNKNOWN, List.of(), scene);

        assertThat(world.read(message)).isTrue();
        assertThat(textOf(world.scene())).isEqualTo(textOf(scene));
    }

    @Property(tries = 300)
    void readerStaysWithinTheThresholdOfAMovingScene(@ForAll long seed) {
        Random random = new Random(seed);
        List<SceneNode> scene = randomNodes(random, 3);
        MonitorMessageWriter writer = new MonitorMessageWriter(environment);
        MonitoredWorld world = new MonitoredWorld();
        world.read(writer.writeFull(MonitoredGame.UNKNOWN, List.of(), scene));

        for (int step = 0; step < 20; step++) {
            scene.forEach(node -> change(node, random));
            assertThat(world.read(writer.writePartial(MonitoredGame.UNKNOWN, List.of(), scene)))
                    .isTrue();
            assertThat(distance(scene, world.scene())).isLessThan(SceneWriter.THRESHOLD + 1e-4f);
        }
    }

    private static List<SceneNode> randomNodes(Random random, int depth) {
        List<SceneNode> nodes = new ArrayList<>();
        for (int i = random.nextInt(5); i >= 0; i--) {
            nodes.add(randomNode(random, depth));
        }
        return nodes;
    }

    private static SceneNode randomNode(Random random, int depth) {
        return switch (random.nextInt(depth > 0 ? 6 : 3)) {
            case 0 -> new LightNode(Colour.grey(1), Colour.grey(random.nextInt(5) / 4f), Colour.grey(0.5f));
            case 1 ->
                new MeshNode(
                        new MeshFile("models/a.obj", List.of()),
                        1,
                        2,
                        3,
                        List.of("x", "y"),
                        random.nextBoolean(),
                        true);
            case 2 ->
                new MeshNode(new StandardShape("StdCapsule", List.of("0.1", "2")), 1, 1, 1, List.of("m"), false, false);
            default -> new TransformNode(randomMatrix(random), randomNodes(random, depth - 1));
        };
    }

    private static float[] randomMatrix(Random random) {
        float[] matrix = new float[16];
        for (int i = 0; i < 16; i++) {
            matrix[i] = (float) (random.nextGaussian() * Math.pow(10, -random.nextInt(9)));
        }
        return matrix;
    }

    private static void change(SceneNode node, Random random) {
        if (node instanceof MeshNode mesh) {
            mesh.setVisible(random.nextBoolean());
        } else if (node instanceof TransformNode transform) {
            float[] matrix = new float[16];
            for (int i = 0; i < 16; i++) {
                matrix[i] = transform.element(i) + 0.004f * (random.nextFloat() - 0.5f);
            }
            transform.moveTo(matrix, 0);
            transform.children().forEach(child -> change(child, random));
        }
    }

    private static float distance(List<SceneNode> left, List<SceneNode> right) {
        float worst = 0;
        for (int i = 0; i < left.size(); i++) {
            worst = Math.max(worst, distance(left.get(i), right.get(i)));
        }
        return worst;
    }

    private static float distance(SceneNode left, SceneNode right) {
        if (left instanceof MeshNode mesh) {
            assertThat(((MeshNode) right).isVisible()).isEqualTo(mesh.isVisible());
        }
        if (!(left instanceof TransformNode here)) {
            return 0;
        }
        TransformNode there = (TransformNode) right;
        float worst = distance(here.children(), there.children());
        for (int i = 0; i < 16; i++) {
            worst = Math.max(worst, Math.abs(here.element(i) - there.element(i)));
        }
        return worst;
    }

    private String textOf(List<SceneNode> scene) {
        return new MonitorMessageWriter(environment)
                .writeFullForNewcomer(MonitoredGame.UNKNOWN, scene)
                .toString();
    }
}
