package org.robonewbie.simulator.server;

import java.io.IOException;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.frame.MessageBuffer;
import org.robonewbie.protocol.perceptor.PerceptorMessage;
import org.robonewbie.protocol.perceptor.PerceptorMessageReader;

/** The simplest agent: says what it is told to and reads each answer. */
final class TestAgent implements AutoCloseable {

    private final AgentLink link;
    private final MessageBuffer message = new MessageBuffer();
    private final PerceptorMessageReader reader = new PerceptorMessageReader();

    TestAgent(AgentLink link) {
        this.link = link;
    }

    /** Creates a robot, joins a team as the original client does, and returns the message with the number. */
    PerceptorMessage join(String team, int number) throws IOException {
        return join("rsg/agent/nao/nao.rsg", team, number);
    }

    /** Creates a certain robot and joins a team. */
    PerceptorMessage join(String scene, String team, int number) throws IOException {
        send("(scene " + scene + ")(syn)");
        receive();
        send("(init (unum " + number + ")(teamname " + team + "))(syn)");
        receive();
        send("(syn)");
        return receive();
    }

    /** Joins a game that does not wait for its agents; returns the message with the number, or the last of many without. */
    PerceptorMessage joinRunningGame(String team, int number) throws IOException {
        exchange("(scene rsg/agent/nao/nao.rsg)");
        PerceptorMessage answer = exchange("(init (unum " + number + ")(teamname " + team + "))");
        for (int i = 0; i < 60 && answer.gameState().orElseThrow().number().isEmpty(); i++) {
            answer = receive();
        }
        return answer;
    }

    void send(String text) throws IOException {
        message.clear();
        message.append(text);
        link.send(message);
    }

    PerceptorMessage receive() throws IOException {
        return reader.read(receiveText());
    }

    MessageBuffer receiveText() throws IOException {
        if (!link.receive(message)) {
            throw new IOException("The simulator has ended.");
        }
        return message;
    }

    PerceptorMessage exchange(String text) throws IOException {
        send(text);
        return receive();
    }

    @Override
    public void close() throws IOException {
        link.close();
    }
}
