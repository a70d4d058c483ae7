// The sentences of the engine's derivation in German; formulas stand as {0}, {1}, … in their order.
export const derivation: Record<string, string> = {
  'What is given': 'Was gegeben ist',
  'Masses, centres at the moment of contact, and velocities before the collision, in any consistent units:':
    'Massen, Mittelpunkte im Augenblick der Berührung und Geschwindigkeiten vor dem Stoß, in beliebigen zueinander passenden Einheiten:',
  'Both fly straight and with constant velocity until they touch at the time {0}; the centres above are those at this moment.':
    'Beide fliegen geradeaus mit gleichbleibender Geschwindigkeit, bis sie sich zur Zeit {0} berühren; die Mittelpunkte oben sind die in diesem Augenblick.',
  'The collision is elastic (restitution {0}): kinetic energy is kept.':
    'Der Stoß ist elastisch (Stoßzahl {0}): Die kinetische Energie bleibt erhalten.',
  'The restitution is {0}: the collision is not elastic, kinetic energy is lost.':
    'Die Stoßzahl ist {0}: Der Stoß ist nicht elastisch, kinetische Energie geht verloren.',
  'Below, {0} is exact and {1} means rounded to {2} significant digits. Every line uses the numbers as they are printed above it.':
    'Im Folgenden ist {0} genau, {1} heißt auf {2} geltende Ziffern gerundet. Jede Zeile rechnet mit den Zahlen, wie sie über ihr stehen.',
  'The normal and the tangent': 'Normale und Tangente',
  'The normal runs from the centre of disk 1 to the centre of disk 2:':
    'Die Normale läuft vom Mittelpunkt der Scheibe 1 zum Mittelpunkt der Scheibe 2:',
  'The distance of the centres is the sum of the radii: the disks touch.':
    'Der Abstand der Mittelpunkte ist die Summe der Radien: Die Scheiben berühren sich.',
  'The centres are closer than the sum of the radii: the disks overlap. The normal is the line of centres all the same.':
    'Die Mittelpunkte sind näher als die Summe der Radien: Die Scheiben überlappen sich. Die Normale ist trotzdem die Verbindung der Mittelpunkte.',
  'The centres are farther apart than the sum of the radii: the disks do not touch yet. What follows takes the normal as they stand.':
    'Die Mittelpunkte sind weiter entfernt als die Summe der Radien: Die Scheiben berühren sich noch nicht. Das Folgende nimmt die Normale so, wie sie stehen.',
  'The unit normal is the normal divided by its length:': 'Der Einheitsvektor der Normalen ist die Normale, geteilt durch ihre Länge:',
  'The tangent is perpendicular to the normal. Divided by the same length it is the unit tangent:':
    'Die Tangente steht senkrecht auf der Normalen. Durch dieselbe Länge geteilt ist sie der Einheitsvektor der Tangente:',
  'The velocities along the normal and the tangent': 'Die Geschwindigkeiten entlang Normale und Tangente',
  'The dot product with a unit vector is the part of a velocity in its direction, a number with a sign:':
    'Das Skalarprodukt mit einem Einheitsvektor ist der Anteil der Geschwindigkeit in dessen Richtung, eine Zahl mit Vorzeichen:',
  'Do they approach?': 'Nähern sie sich?',
  'The distance of the centres shrinks at the rate': 'Der Abstand der Mittelpunkte nimmt ab mit der Geschwindigkeit',
  'This is positive: the disks approach, so they collide.': 'Das ist positiv: Die Scheiben nähern sich, also stoßen sie zusammen.',
  'This is negative: the disks move apart already. They do not collide.':
    'Das ist negativ: Die Scheiben entfernen sich schon. Sie stoßen nicht zusammen.',
  'The distance does not change: the disks at most slide along each other. They do not collide.':
    'Der Abstand ändert sich nicht: Die Scheiben gleiten höchstens aneinander entlang. Sie stoßen nicht zusammen.',
  'The velocities stay': 'Die Geschwindigkeiten bleiben',
  'Without a collision there is no impulse, and both disks keep their velocities:':
    'Ohne Stoß gibt es keinen Kraftstoß, und beide Scheiben behalten ihre Geschwindigkeit:',
  'The collision along the normal': 'Der Stoß entlang der Normalen',
  'Along the normal the disks collide head-on, as on a straight line. Momentum is kept (equation 1), and so is kinetic energy (equation 2):':
    'Entlang der Normalen stoßen die Scheiben gerade zusammen, wie auf einer Schiene. Der Impuls bleibt erhalten (Gleichung 1) und die kinetische Energie auch (Gleichung 2):',
  'Sorted by disks, and (2) multiplied by 2:': 'Nach Scheiben geordnet, und (2) mit 2 malgenommen:',
  'Dividing (4) by (3) leaves {0}. Put into (3), this gives:': 'Teilt man (4) durch (3), bleibt {0}. In (3) eingesetzt ergibt das:',
  '(The source text prints {0} in its line for {1} in two dimensions; it has to be {2}, as in its own equation 5.)':
    '(Der Quelltext druckt in seiner Zeile für {1} in zwei Dimensionen {0}; es muss {2} heißen, wie in seiner eigenen Gleichung 5.)',
  'The masses are equal: their difference vanishes, and the disks exchange their normal velocities:':
    'Die Massen sind gleich: Ihre Differenz verschwindet, und die Scheiben tauschen ihre Normalgeschwindigkeiten:',
  'Along the normal the disks collide head-on, as on a straight line. Momentum is kept (equation 1, sorted by disks equation 3):':
    'Entlang der Normalen stoßen die Scheiben gerade zusammen, wie auf einer Schiene. Der Impuls bleibt erhalten (Gleichung 1, nach Scheiben geordnet Gleichung 3):',
  'Kinetic energy is not kept, so equations 2 and 4 do not hold. In their place, the disks separate with {0} times the speed at which they approached:':
    'Die kinetische Energie bleibt nicht erhalten, also gelten die Gleichungen 2 und 4 nicht. An ihrer Stelle trennen sich die Scheiben mit dem {0}-fachen der Geschwindigkeit, mit der sie sich näherten:',
  'The two together give, in place of equations 5 and 6 (which they become for {0}):':
    'Beide zusammen ergeben, an Stelle der Gleichungen 5 und 6 (zu denen sie für {0} werden):',
  'The kinetic energy that is lost:': 'Die kinetische Energie, die verloren geht:',
  'The tangential parts stay': 'Die tangentialen Anteile bleiben',
  'The disks are smooth: no friction acts along the tangent, so nothing changes there.':
    'Die Scheiben sind glatt: Entlang der Tangente wirkt keine Reibung, also ändert sich dort nichts.',
  'Back to vectors': 'Zurück zu Vektoren',
  'Disk 1: the new normal part times the unit normal, the tangential part times the unit tangent, and their sum:':
    'Scheibe 1: der neue Normalanteil mal Einheitsnormale, der Tangentialanteil mal Einheitstangente, und ihre Summe:',
  'Disk 2:': 'Scheibe 2:',
  'The same at once: equations A to D': 'Dasselbe auf einmal: Gleichungen A bis D',
  'For equal masses everything fits into four formulas, without a square root:':
    'Für gleiche Massen passt alles in vier Formeln, ohne Wurzel:',
  'These are the velocities found above, up to the rounding of the numbers shown. These went through fewer roundings, so the check takes them:':
    'Das sind die Geschwindigkeiten von oben, bis auf die Rundung der gezeigten Zahlen. Diese hier wurden seltener gerundet, deshalb nimmt die Probe sie:',
  'These are the velocities found above:': 'Das sind die Geschwindigkeiten von oben:',
  'The check: impulse, momentum, energy': 'Die Probe: Kraftstoß, Impuls, Energie',
  'Disk 2 has received an impulse along the normal, and disk 1 the opposite:':
    'Scheibe 2 hat einen Kraftstoß entlang der Normalen erhalten, Scheibe 1 den entgegengesetzten:',
  'Momentum before and after:': 'Impuls vorher und nachher:',
  'Momentum is kept.': 'Der Impuls bleibt erhalten.',
  'Momentum is kept to six digits; the rest is the rounding of the numbers shown.':
    'Der Impuls bleibt auf sechs Ziffern erhalten; der Rest ist die Rundung der gezeigten Zahlen.',
  'The difference is the rounding of the numbers shown.': 'Der Unterschied ist die Rundung der gezeigten Zahlen.',
  'Kinetic energy before and after:': 'Kinetische Energie vorher und nachher:',
  'Kinetic energy is kept.': 'Die kinetische Energie bleibt erhalten.',
  'Kinetic energy is kept to six digits; the rest is the rounding of the numbers shown.':
    'Die kinetische Energie bleibt auf sechs Ziffern erhalten; der Rest ist die Rundung der gezeigten Zahlen.',
  'What is missing is {0}, the energy lost.': 'Was fehlt, ist {0}, die verlorene Energie.',
  'What is missing is {0}, the energy lost, to six digits of the energy before; the rest is the rounding of the numbers shown.':
    'Was fehlt, ist {0}, die verlorene Energie, auf sechs Ziffern der Energie vorher; der Rest ist die Rundung der gezeigten Zahlen.',
  'In double precision': 'In doppelter Genauigkeit',
  'The velocities after, as {0} gives them, from the impulse form of the same rule:':
    'Die Geschwindigkeiten nachher, wie {0} sie ausgibt, aus der Kraftstoßform derselben Regel:',
  'They differ from those above by more than the sixth digit: the given numbers differ too little, or are too far apart in size, for double precision to hold what the calculation needs.':
    'Sie weichen von denen oben um mehr als die sechste Ziffer ab: Die gegebenen Zahlen unterscheiden sich zu wenig oder sind zu verschieden groß, als dass doppelte Genauigkeit fasst, was die Rechnung braucht.',
};
