package org.robonewbie.agent;

import java.io.IOException;
import java.util.List;
import org.robonewbie.protocol.effector.EffectorMessageWriter;
import org.robonewbie.protocol.frame.MessageBuffer;

/**
 * Brings a robot into the game: builds it, joins a team, waits for number and side, goes to the first place and stands there.
 * Each received message is answered once, so it works with servers that wait for their agents and with those that do not.
 */
final class StartDialogue {

    private static final String SCENE = "rsg/agent/nao/nao.rsg";
    private static final String SCENE_OF_TYPE = "rsg/agent/nao/nao_hetero.rsg";
    private static final int PATIENCE_MESSAGES = 100;
    private static final int MESSAGES_TO_SETTLE = 15;

    private final MessagePort port;
    private final NaoBody body;
    private final Options options;
    private final MessageBuffer buffer = new MessageBuffer();

    StartDialogue(MessagePort port, NaoBody body, Options options) {
        this.port = port;
        this.body = body;
        this.options = options;
    }

    void run() throws IOException {
        body.senses().setTeam(options.team());
        EffectorMessageWriter writer = new EffectorMessageWriter(buffer);
        if (options.type() == 0) {
            writer.createRobot(SCENE, List.of());
        } else {
            writer.createRobot(SCENE_OF_TYPE, List.of(Integer.toString(options.type())));
        }
        answer();
        receive();
        writer.joinTeam(options.number(), options.team());
        answer();
        waitForNumber();
        StartPose pose = options.pose().orElseGet(() -> StartPose.ofNumber(body.getNumber()));
        writer.beam(pose.x(), pose.y(), pose.degrees());
        answer();
        for (int i = 0; i < MESSAGES_TO_SETTLE; i++) {
            receive();
            answer();
        }
        body.senses().falls().reset();
    }

    private void waitForNumber() throws IOException {
        for (int i = 0; i < PATIENCE_MESSAGES; i++) {
            receive();
            if (body.senses().isJoined()) {
                return;
            }
            answer();
        }
        throw new StartUpException("The simulator has refused number " + options.number() + " of team "
                + options.team() + ": choose a number that is free (--number 0 takes any), or the name of a team that"
                + " plays already (--team).");
    }

    private void receive() throws IOException {
        if (!port.receive()) {
            throw new IOException("it has closed the connection");
        }
        body.accept(port.message());
    }

    private void answer() throws IOException {
        new EffectorMessageWriter(buffer).synchronise();
        port.send(buffer);
        buffer.clear();
    }
}
