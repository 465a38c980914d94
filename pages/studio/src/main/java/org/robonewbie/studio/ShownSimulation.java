package org.robonewbie.studio;

import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import org.robonewbie.nao.SoccerField;
import org.robonewbie.protocol.frame.AgentLink;
import org.robonewbie.protocol.order.Order;
import org.robonewbie.simulator.PitchDetails;
import org.robonewbie.simulator.SimulationControl;
import org.robonewbie.simulator.SimulationObserver;
import org.robonewbie.simulator.TrialLabel;
import org.robonewbie.simulator.WorldSnapshot;
import org.robonewbie.simulator.state.WorldState;

/**
 * Proxy for the displayed simulation. It switches between free play and trials of exercises; each switch moves the
 * observers to the new simulation.
 */
public final class ShownSimulation implements SimulationControl {

    private final List<SimulationObserver> observers = new CopyOnWriteArrayList<>();
    private volatile SimulationControl shown;

    /**
     * Creates a proxy.
     *
     * @param first the simulation to show first
     */
    public ShownSimulation(SimulationControl first) {
        this.shown = first;
    }

    /**
     * Shows another simulation. The previous one continues in the background.
     *
     * @param other the simulation to show
     */
    public synchronized void show(SimulationControl other) {
        if (other == shown) {
            return;
        }
        observers.forEach(shown::removeObserver);
        shown = other;
        observers.forEach(other::addObserver);
        observers.forEach(SimulationObserver::simulationReplaced);
    }

    @Override
    public SoccerField field() {
        return shown.field();
    }

    @Override
    public PitchDetails pitchDetails() {
        return shown.pitchDetails();
    }

    @Override
    public boolean canSetMatch() {
        return shown.canSetMatch();
    }

    @Override
    public boolean hasClock() {
        return shown.hasClock();
    }

    @Override
    public void order(Order order) {
        shown.order(order);
    }

    @Override
    public void restore(WorldSnapshot before, WorldSnapshot moment) {
        shown.restore(before, moment);
    }

    @Override
    public void save(Consumer<Optional<WorldState>> receiver) {
        shown.save(receiver);
    }

    @Override
    public void restore(WorldState state, Consumer<OptionalInt> receiver) {
        shown.restore(state, receiver);
    }

    @Override
    public Optional<TrialLabel> trial() {
        return shown.trial();
    }

    @Override
    public OptionalInt agentPort() {
        return shown.agentPort();
    }

    @Override
    public Optional<AgentLink> connect() {
        return shown.connect();
    }

    @Override
    public synchronized void addObserver(SimulationObserver observer) {
        observers.add(observer);
        shown.addObserver(observer);
    }

    @Override
    public synchronized void removeObserver(SimulationObserver observer) {
        observers.remove(observer);
        shown.removeObserver(observer);
    }
}
