"""A rotor by transfer matrices: frequencies, critical speeds, response, torsion."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from analytic.rotor.rotor_study import Study, branches, study
from verify.case import Quantity, shared
from verify.cases.rotor.system.inputs import CRITICALS, FREQUENCIES, critical_name
from verify.cases.rotor.system.transfer import DescribedRotor

ORDERS = range(1, FREQUENCIES + 1)
TURN = 2 * np.pi  # frequencies are in Hz, speeds in rad/s

Array = NDArray[np.float64]


def _found(group: int) -> Any:
    """Function that returns whether shafts of group `group` excite at least `k` critical speeds."""

    def has(q: Any, k: int) -> bool:
        excited = q.study.excited
        return len(excited) >= group and len(excited[group - 1].speeds) >= k

    return has


def _turning(q: Any) -> bool:
    """Whether any shaft with an unbalance rotates."""
    return bool(q.study.responses)


class TransferRotor(DescribedRotor):
    """Results of transfer matrices of a rotor; speeds in rad/s, frequencies in Hz."""

    @Quantity("ω_1", "rad/s", "lowest natural frequency at speed n", role="step",
              source="rotating shaft by Timoshenko's theory; the number of negative "
                     "eigenvalues of D equals the number of roots below ω, so that no root is "
                     "missed",
              tex=r"\omega,\quad \det D(\omega, n)=0,\quad "
              r"\frac{d}{dz}\begin{pmatrix} r\\ \varphi\\ Q\\ M\end{pmatrix}="
              r"\begin{pmatrix} 0&1&\frac{1}{\kappa GA}&0\\ 0&0&0&\frac{1}{EI}\\ "
              r"-\rho A\omega^2&0&0&0\\ 0&-\rho I(\omega^2-2\Omega\omega)&-1&0\end{pmatrix}"
              r"\begin{pmatrix} r\\ \varphi\\ Q\\ M\end{pmatrix}")  # fmt: skip
    def lowest(self) -> float:
        return float(self.study.modes.w[0])

    @Quantity("f_{0}", "Hz", "natural frequency {0} at speed n",
              when=lambda q, k: len(q.study.modes.w) >= k).over(ORDERS)  # fmt: skip
    def frequency(self, k: int) -> float:
        return float(self.study.modes.w[k - 1] / TURN)

    @Quantity("s_{0}", "1", "sense of whirl of mode {0} (1 = forward, −1 = backward)", role="step",
              when=lambda q, k: len(q.study.modes.w) >= k).over(ORDERS)  # fmt: skip
    def sense(self, k: int) -> float:
        return float(self.study.modes.whirl[k - 1])

    @Quantity("n_c{0}", "r/min", "critical speed {0} excited by the unbalance of the first shaft",
              safe="too low", when=_found(1)).over(range(1, CRITICALS + 1))  # fmt: skip
    def critical_first(self, k: int) -> float:
        return float(self.study.excited[0].speeds[k - 1])

    @Quantity("n_c{0}'", "r/min", "critical speed {0} excited by the unbalance of a shaft whose "
              "speed differs from that of the first shaft",
              safe="too low",
              when=_found(2)).over(range(1, CRITICALS + 1))  # fmt: skip
    def critical_other(self, k: int) -> float:
        return float(self.study.excited[1].speeds[k - 1])

    @Quantity("f_t", "Hz", "lowest torsional frequency")
    def torsion(self) -> float:
        return float(self.study.torsion[0] / TURN)

    @Quantity("f_{0}E", "Hz", "natural frequency {0} by Euler's theory", role="step",
              when=lambda q, k: len(q.study.slender) >= k).over(ORDERS)  # fmt: skip
    def euler(self, k: int) -> float:
        return float(self.study.slender[k - 1] / TURN)

    @Quantity("|r|", "µm", "amplitude of the probe node", safe="too high", when=_turning)
    def amplitude(self) -> float:
        return float(sum(r.amplitude(self.probe - 1)[0] for r in self.study.responses))

    @Quantity("F_s", "N", "load of supports[1], the first bearing to the ground", safe="too high",
              when=_turning)  # fmt: skip
    def support_load(self) -> float:
        return float(sum(r.load(self.rotor.supports[0])[0] for r in self.study.responses))

    @Quantity("F_l", "N", "load of links[1], the first bearing between shafts", safe="too high",
              when=lambda q: _turning(q) and q.rotor.links)  # fmt: skip
    def link_load(self) -> float:
        return float(sum(r.load(self.rotor.links[0])[0] for r in self.study.responses))

    @shared
    def study(self) -> Study:
        """Modes at the speed, critical speeds for each shaft's unbalance, response and torsion."""
        names = tuple(shaft.name for shaft in self.shafts)
        return study(self.rotor, names, self.speed, self.unbalanced(), FREQUENCIES)

    @property
    def undamped(self) -> dict[str, float]:
        """Natural frequencies and critical speeds, by name."""
        found = {f"frequency_{k}": w / TURN for k, w in enumerate(self.study.modes.w, start=1)}
        for group, excited in enumerate(self.study.excited, start=1):
            speeds = enumerate(excited.speeds[:CRITICALS], start=1)
            found |= {f"{critical_name(group)}_{k}": w for k, w in speeds}
        return found

    @shared
    def speed_axis(self) -> float:
        """Upper end [rad/s] of speed axes; they include the next critical speed above operation."""
        top = max(self.speed_to, self.speed)
        above = [w for excited in self.study.excited for w in excited.speeds if w > top]
        return float(max(1.2 * top, 1.1 * min(above, default=0.0)))

    @shared
    def campbell(self) -> tuple[Array, Array, tuple[int, ...]]:
        """Speeds (n,), natural frequencies (n, branches) [rad/s] and the sense of each branch."""
        return branches(self.rotor, self.speed_axis, self.study.modes, FREQUENCIES)
