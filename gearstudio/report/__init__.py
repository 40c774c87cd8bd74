"""The report: a PDF with the design, its data sheets, the comparison, maps, contact and the equations used."""
